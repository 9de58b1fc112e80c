# Installed tree: libraries, headers, examples, and what find_package(waywright) needs.
include(CMakePackageConfigHelpers)
get_property(targets GLOBAL PROPERTY WAYWRIGHT_TARGETS)
install(TARGETS ${targets} EXPORT waywright ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS waywright RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS waywright_external_ompl EXPORT waywright)
install(DIRECTORY src/waywright DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp"
        PATTERN "fixture_stations.hpp" EXCLUDE PATTERN "test_paths.hpp" EXCLUDE)
install(FILES ${PROJECT_BINARY_DIR}/generated/waywright/core/version.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/waywright/core)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DATADIR}/waywright)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/waywright)
install(EXPORT waywright NAMESPACE waywright:: DESTINATION ${config_dir})
configure_package_config_file(cmake/waywrightConfig.cmake.in ${PROJECT_BINARY_DIR}/waywrightConfig.cmake
                              INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/waywrightConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/waywrightConfig.cmake ${PROJECT_BINARY_DIR}/waywrightConfigVersion.cmake
        DESTINATION ${config_dir})
