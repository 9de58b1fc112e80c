# The docking core alone, for compilers that have no libraries of their own to link: fmt, Boost and tl::expected come as headers from one
# folder, GoogleTest from its sources.
set(WAYWRIGHT_HEADERS "" CACHE PATH "Folder that holds fmt/, boost/ and tl/")
set(WAYWRIGHT_GTEST_SOURCES "" CACHE PATH "Folder that holds GoogleTest's src/ and include/")

include_directories(SYSTEM ${WAYWRIGHT_HEADERS})
add_library(waywright_fmt_headers INTERFACE)
target_compile_definitions(waywright_fmt_headers INTERFACE FMT_HEADER_ONLY=1)
add_library(fmt::fmt-header-only ALIAS waywright_fmt_headers)
add_library(waywright_boost_headers INTERFACE)
add_library(Boost::headers ALIAS waywright_boost_headers)

if(WAYWRIGHT_TESTS)
  add_library(waywright_gtest STATIC ${WAYWRIGHT_GTEST_SOURCES}/src/gtest-all.cc ${WAYWRIGHT_GTEST_SOURCES}/src/gtest_main.cc)
  target_include_directories(waywright_gtest SYSTEM PUBLIC ${WAYWRIGHT_GTEST_SOURCES}/include PRIVATE ${WAYWRIGHT_GTEST_SOURCES})
  add_library(GTest::gtest ALIAS waywright_gtest)
  add_library(GTest::gtest_main ALIAS waywright_gtest)
endif()
