# What every target of the house has in common: warnings, sanitizers, ccache and a fast linker where present.

add_library(house_warnings INTERFACE)
target_compile_options(house_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
                       -Woverloaded-virtual -Wimplicit-fallthrough
                       # GCC 12: false alarms (PR105651, PR105329), and designated initialisers are house style
                       -Wno-restrict -Wno-stringop-overread -Wno-missing-field-initializers $<$<BOOL:${FIDELIS_WERROR}>:-Werror>)

if(FIDELIS_SANITIZE)
  add_compile_options(-fsanitize=${FIDELIS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${FIDELIS_SANITIZE})
endif()

# Same input, same bytes: no contraction into fused multiply-adds that depend on the compiler's mood.
add_compile_options(-ffp-contract=off)

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Paths count from the source folder: a fresh clone elsewhere compiles what it shares with this one from the cache.
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${CCACHE_PROGRAM})
endif()
find_program(MOLD_PROGRAM mold)
if(MOLD_PROGRAM)
  add_link_options(-fuse-ld=mold)
endif()

# house_library(NAME SOURCES a.cpp … HEADERS a.h … PUBLIC targets that headers show … PRIVATE the rest …)
# One folder is one namespace is one static library; includes start at the project's root.
function(house_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;HEADERS;PUBLIC;PRIVATE")
  add_library(${name} STATIC ${arg_SOURCES})
  target_sources(${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${arg_HEADERS})
  target_link_libraries(${name} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE} house_warnings)
endfunction()

# house_room(LIBRARY SOURCES … HEADERS …): a folder inside a library's folder, with a list of its own.
function(house_room library)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;HEADERS")
  target_sources(${library} PRIVATE ${arg_SOURCES})
  target_sources(${library} PUBLIC FILE_SET HEADERS FILES ${arg_HEADERS})
endfunction()

# house_program(PROGRAM): takes its memory from mimalloc, which gives back what is freed. The GNU C library keeps it where
# small blocks stay between large ones: 2.4 GB of a diagnosis that needs a fifth of that. Sanitizers bring an allocator.
function(house_program program)
  if(NOT FIDELIS_SANITIZE)
    target_link_libraries(${program} PRIVATE mimalloc)
  endif()
endfunction()

# house_test(NAME SOURCES a_test.cpp … LINK targets …): one GoogleTest program per folder.
function(house_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINK")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINK} test_support GTest::gmock_main house_warnings)
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 300)
endfunction()
