# Installed tree: libraries, headers, examples, and what find_package(waywright) needs.
include(CMakePackageConfigHelpers)
get_property(targets GLOBAL PROPERTY WAYWRIGHT_TARGETS)
# The part for vehicles' own programs is a set of its own, so that it can be found without the other libraries.
set(docking_targets ${targets})
list(FIND targets waywright_docking last)
math(EXPR count "${last} + 1")
list(SUBLIST targets 0 ${count} docking_targets)
list(REMOVE_ITEM targets ${docking_targets})
install(TARGETS ${docking_targets} EXPORT waywright_docking ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS ${targets} EXPORT waywright ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS waywright RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS waywright_external_ompl EXPORT waywright)
install(DIRECTORY src/waywright DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp" PATTERN "docking.h"
        PATTERN "fixture_stations.hpp" EXCLUDE PATTERN "test_paths.hpp" EXCLUDE PATTERN "test_drawing.hpp" EXCLUDE PATTERN "test_plans.hpp" EXCLUDE
        PATTERN "dxf_module.h" EXCLUDE)
install(FILES ${PROJECT_BINARY_DIR}/generated/waywright/core/version.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/waywright/core)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DATADIR}/waywright)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/waywright)
install(EXPORT waywright_docking NAMESPACE waywright:: DESTINATION ${config_dir})
install(EXPORT waywright NAMESPACE waywright:: DESTINATION ${config_dir})
configure_package_config_file(cmake/waywrightConfig.cmake.in ${PROJECT_BINARY_DIR}/waywrightConfig.cmake
                              INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/waywrightConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/waywrightConfig.cmake ${PROJECT_BINARY_DIR}/waywrightConfigVersion.cmake
        DESTINATION ${config_dir})
