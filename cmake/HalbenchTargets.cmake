# Warnings are errors in everything we write.
add_library(halbench_options INTERFACE)
target_include_directories(halbench_options INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_options(halbench_options INTERFACE -Wall -Wextra -Wshadow -Wconversion -Werror
  $<$<COMPILE_LANGUAGE:C>:-Wstrict-prototypes> -fno-fast-math -ffp-contract=off)
target_compile_definitions(halbench_options INTERFACE HALBENCH_VERSION="${PROJECT_VERSION}"
  QT_NO_CAST_FROM_ASCII_STRICT QT_NO_KEYWORDS)
if(HALBENCH_BUILD_FUZZERS) # coverage of the libraries guides the fuzzer
  target_compile_options(halbench_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
if(HALBENCH_SANITIZE)
  target_compile_options(halbench_options INTERFACE -fsanitize=${HALBENCH_SANITIZE}
    -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(halbench_options INTERFACE -fsanitize=${HALBENCH_SANITIZE})
endif()

# halbench_library(control_lti DEPENDS control_base ...): one static library of all sources in this folder
# (not its sub-folders). A folder without sources becomes an interface library, so that its dependants link.
# AUTOMOC: the folder has Q_OBJECT classes.
function(halbench_library name)
  cmake_parse_arguments(ARG "RECURSE;AUTOMOC" "" "DEPENDS" ${ARGN})
  if(ARG_RECURSE)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp *.c)
    list(FILTER sources EXCLUDE REGEX "/(boards|examples)/")
  else()
    file(GLOB sources CONFIGURE_DEPENDS *.cpp *.c)
  endif()
  if(sources)
    add_library(${name} STATIC ${sources})
    target_link_libraries(${name} PUBLIC halbench_options halbench_expected ${ARG_DEPENDS})
    if(ARG_AUTOMOC)
      set_target_properties(${name} PROPERTIES AUTOMOC ON)
      # By itself moc only notices changes in files it knows: a new or vanished one makes it start over.
      set(known ${CMAKE_CURRENT_BINARY_DIR}/${name}_sources.txt)
      set(before "")
      if(EXISTS ${known})
        file(READ ${known} before)
      endif()
      if(NOT before STREQUAL "${sources}")
        file(REMOVE ${CMAKE_CURRENT_BINARY_DIR}/${name}_autogen/timestamp)
        file(WRITE ${known} "${sources}")
      endif()
    endif()
  else()
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE halbench_options halbench_expected ${ARG_DEPENDS})
  endif()
endfunction()

# halbench_test(control_lti): every *_test.cpp of this folder in one program, each case a ctest entry.
# LABELS night marks a suite that only `./dev test --night` runs.
function(halbench_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "DEPENDS;LABELS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS *.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(test_${name} ${sources})
  target_link_libraries(test_${name} PRIVATE halbench_options halbench_expected ${ARG_DEPENDS}
    GTest::gmock GTest::gtest_main)
  # Only where it is used: a path in every command line would keep clones from sharing compiled objects.
  foreach(source ${sources})
    file(STRINGS ${source} uses REGEX HALBENCH_SOURCE_DIR LIMIT_COUNT 1)
    if(uses)
      set_property(SOURCE ${source} APPEND PROPERTY COMPILE_DEFINITIONS HALBENCH_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
    endif()
  endforeach()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  gtest_discover_tests(test_${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS "${ARG_LABELS}")
endfunction()

# halbench_resources(presets /presets ROOT files...): compiles files in as :PREFIX/<path below ROOT>; the caller gets
# the generated sources as ${<name>_sources}.
function(halbench_resources name prefix root)
  set(entries "")
  foreach(file ${ARGN})
    file(RELATIVE_PATH alias ${root} ${file})
    string(APPEND entries "  <file alias=\"${alias}\">${file}</file>\n")
  endforeach()
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}.qrc CONTENT
    "<RCC><qresource prefix=\"${prefix}\">\n${entries}</qresource></RCC>\n" @ONLY)
  qt5_add_resources(generated ${CMAKE_CURRENT_BINARY_DIR}/${name}.qrc)
  set(${name}_sources ${generated} PARENT_SCOPE)
endfunction()
