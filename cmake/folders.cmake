# A folder of src/waywright is a library; what it may use stands in its one statement.

# waywright_folder(NAME FOLDER folder [USES folders…] [LINKS external libraries, not passed on])
function(waywright_folder name)
  cmake_parse_arguments(arg "" "FOLDER" "USES;LINKS" ${ARGN})
  if(NOT arg_FOLDER)
    set(arg_FOLDER ${name})
  endif()
  set(dir ${CMAKE_CURRENT_SOURCE_DIR}/${arg_FOLDER})
  file(GLOB sources CONFIGURE_DEPENDS ${dir}/*.cpp)
  set(tests ${sources})
  list(FILTER tests INCLUDE REGEX "_test\\.cpp$")
  list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")

  add_library(waywright_${name} STATIC ${sources})
  add_library(waywright::${name} ALIAS waywright_${name})
  set_target_properties(waywright_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  set_property(GLOBAL APPEND PROPERTY WAYWRIGHT_TARGETS waywright_${name})
  target_compile_features(waywright_${name} PUBLIC cxx_std_20)
  target_include_directories(waywright_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  foreach(used IN LISTS arg_USES)
    target_link_libraries(waywright_${name} PUBLIC waywright_${used})
  endforeach()
  foreach(library IN LISTS arg_LINKS)
    if(library MATCHES "headers?-only|::headers|::Eigen")  # not passed on, not even to the linker
      target_link_libraries(waywright_${name} PRIVATE $<BUILD_INTERFACE:${library}>)
    else()
      target_link_libraries(waywright_${name} PRIVATE ${library})
    endif()
  endforeach()
  waywright_flags(waywright_${name})

  if(WAYWRIGHT_TESTS AND tests)
    waywright_test(${name}_test ${tests})
    target_link_libraries(${name}_test PRIVATE waywright_${name} ${arg_LINKS})
  endif()
endfunction()

function(waywright_flags target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
                         $<$<BOOL:${WAYWRIGHT_WERROR}>:-Werror>)
  # No fused multiply-add that one processor has and another has not: the same bits everywhere.
  target_compile_options(${target} PRIVATE -ffp-contract=off -fno-math-errno)
endfunction()

# Kernels that are compiled once for each instruction set: files kernels_NAME.cpp of a folder, chosen among at run time.
function(waywright_lanes name folder)
  set(plain -O3 -Wno-psabi)
  set_source_files_properties(${folder}/kernels_baseline.cpp PROPERTIES COMPILE_OPTIONS "${plain}")
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    set_source_files_properties(${folder}/kernels_avx2.cpp PROPERTIES COMPILE_OPTIONS "${plain};-mavx2")
    # g++ 12 warns of its own header's use of undefined registers.
    set_source_files_properties(${folder}/kernels_avx512.cpp PROPERTIES COMPILE_OPTIONS
                                "${plain};-mavx512f;-mavx512dq;-Wno-uninitialized;-Wno-maybe-uninitialized")
  else()
    set_source_files_properties(${folder}/kernels_avx2.cpp ${folder}/kernels_avx512.cpp PROPERTIES HEADER_FILE_ONLY ON)
  endif()
endfunction()

# Quick tests have no "Full" in their names; the others run on demand.
function(waywright_test target)
  add_executable(${target} ${ARGN})
  target_link_libraries(${target} PRIVATE GTest::gtest GTest::gtest_main)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_definitions(${target} PRIVATE WAYWRIGHT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  waywright_flags(${target})
  set(timeout 300)
  if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=")  # many times slower
    set(timeout 1800)
  endif()
  gtest_discover_tests(${target} TEST_FILTER "-*Full*" DISCOVERY_MODE PRE_TEST PROPERTIES LABELS quick TIMEOUT ${timeout})
  gtest_discover_tests(${target} TEST_FILTER "*Full*" TEST_SUFFIX ".full" DISCOVERY_MODE PRE_TEST
                       PROPERTIES LABELS full TIMEOUT 3600)
endfunction()
