# Warnings are errors in everything we write.
string(REGEX MATCH "^[0-9]+" HALBENCH_GCC "${CMAKE_CXX_COMPILER_VERSION}")
add_library(halbench_options INTERFACE)
target_include_directories(halbench_options INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_options(halbench_options INTERFACE -Wall -Wextra -Wshadow -Wconversion -Werror
  $<$<COMPILE_LANGUAGE:C>:-Wstrict-prototypes> -fno-fast-math -ffp-contract=off
  # GCC 12 reports moves of strings beyond bounds that it made up itself (its bug 105651), more often with precompiled
  # headers. The address sanitizer sees the real ones.
  "$<$<AND:$<COMPILE_LANG_AND_ID:CXX,GNU>,$<EQUAL:${HALBENCH_GCC},12>>:-Wno-array-bounds;-Wno-restrict;-Wno-stringop-overflow>")
target_compile_definitions(halbench_options INTERFACE HALBENCH_VERSION="${PROJECT_VERSION}"
  QT_NO_CAST_FROM_ASCII_STRICT QT_NO_KEYWORDS)
if(HALBENCH_BUILD_FUZZERS) # coverage of the libraries guides the fuzzer
  target_compile_options(halbench_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
if(HALBENCH_SANITIZE)
  target_compile_options(halbench_options INTERFACE -fsanitize=${HALBENCH_SANITIZE}
    -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(halbench_options INTERFACE -fsanitize=${HALBENCH_SANITIZE})
  if(HALBENCH_SANITIZE_WITHOUT) # must stand after -fsanitize
    target_compile_options(halbench_options INTERFACE -fno-sanitize=${HALBENCH_SANITIZE_WITHOUT})
  endif()
endif()

# halbench_library(control_lti DEPENDS control_base ...): one static library of all sources in this folder
# (not its sub-folders). A folder without sources becomes an interface library, so that its dependants link.
# RECURSE: its sub-folders too. FOLDERS a b: these sub-folders, each with its own, instead of this folder.
# AUTOMOC: the folder has Q_OBJECT classes.
# PRECOMPILED: the layer whose precompiled header its sources read (cmake/Precompiled.cmake).
function(halbench_library name)
  cmake_parse_arguments(ARG "RECURSE;AUTOMOC" "PRECOMPILED" "DEPENDS;FOLDERS" ${ARGN})
  if(ARG_FOLDERS)
    list(TRANSFORM ARG_FOLDERS APPEND "/*.cpp" OUTPUT_VARIABLE patterns)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${patterns})
  elseif(ARG_RECURSE)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp *.c)
    list(FILTER sources EXCLUDE REGEX "/(boards|examples)/")
  else()
    file(GLOB sources CONFIGURE_DEPENDS *.cpp *.c)
  endif()
  if(sources)
    add_library(${name} STATIC ${sources})
    target_link_libraries(${name} PUBLIC halbench_options halbench_expected ${ARG_DEPENDS})
    if(ARG_PRECOMPILED)
      target_precompile_headers(${name} REUSE_FROM precompiled_${ARG_PRECOMPILED})
    endif()
    # Numbers take most of the time of sanitized tests, and without inlining ten to twenty times that of the release.
    if(HALBENCH_SANITIZE AND ARG_PRECOMPILED STREQUAL "numbers")
      target_compile_options(${name} PRIVATE -O2)
    endif()
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

# halbench_test(control_lti): every *.cpp of this folder (and of FOLDERS below it) in one program, run in a few parts by ctest (GoogleTest's
# shards): one process for many cases, since starting one each took most of the time. A failing case is named by its part's
# output. LABELS night marks a suite that only `./dev test --night` runs. PRECOMPILED as above.
add_custom_target(unit_tests)  # what runs under the address sanitizer too: the suites without a label
add_custom_target(night_tests) # what only the night builds
# A test suite whose name ends in Seeds has many random motors, loops or seeds of noise: it runs as NAME_seeds with
# the label statistics, which the sanitizers take at night only. Memory errors show in the first seed as in the last.
function(halbench_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT;PRECOMPILED" "DEPENDS;LABELS;FOLDERS" ${ARGN})
  list(TRANSFORM ARG_FOLDERS APPEND "/*.cpp" OUTPUT_VARIABLE patterns)
  file(GLOB sources CONFIGURE_DEPENDS *.cpp ${patterns})
  if(NOT sources)
    return()
  endif()
  add_executable(test_${name} ${sources})
  target_link_libraries(test_${name} PRIVATE halbench_options halbench_expected halbench_test_options ${ARG_DEPENDS}
    halbench_test_main GTest::gmock)
  if(ARG_PRECOMPILED)
    target_precompile_headers(test_${name} REUSE_FROM precompiled_tests_${ARG_PRECOMPILED})
  endif()
  # Only where it is used: a path in every command line would keep clones from sharing compiled objects.
  foreach(source ${sources})
    file(STRINGS ${source} uses REGEX HALBENCH_SOURCE_DIR LIMIT_COUNT 1)
    if(uses)
      set_property(SOURCE ${source} APPEND PROPERTY COMPILE_DEFINITIONS HALBENCH_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
    endif()
  endforeach()
  if(NOT ARG_LABELS)
    add_dependencies(unit_tests test_${name})
  elseif("night" IN_LIST ARG_LABELS)
    set_target_properties(test_${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    add_dependencies(night_tests test_${name})
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  set(seeds "")
  foreach(source ${sources})
    file(STRINGS ${source} found REGEX "^TEST(_F|_P)?\\([A-Za-z0-9]+Seeds," LIMIT_COUNT 1)
    list(APPEND seeds ${found})
  endforeach()
  if(NOT seeds)
    halbench_test_parts(${name} "${name}" "${ARG_TIMEOUT}" "${ARG_LABELS}" "")
    return()
  endif()
  halbench_test_parts(${name} "${name}" "${ARG_TIMEOUT}" "${ARG_LABELS}" "GTEST_FILTER=-*Seeds.*")
  add_test(NAME ${name}_seeds COMMAND test_${name} --gtest_brief=1 --gtest_filter=*Seeds.*)
  math(EXPR allowed "16 * ${ARG_TIMEOUT}")
  halbench_test_folder(folder ${name}_seeds)
  set_tests_properties(${name}_seeds PROPERTIES TIMEOUT ${allowed} COST ${allowed} LABELS statistics ENVIRONMENT "${folder}")
endfunction()

# Parts of one program run at the same time, as do two builds: each has its own folder for the files it writes
# (testing::TempDir()), or one part reads what another has just written.
function(halbench_test_folder environment test)
  set(folder "${CMAKE_BINARY_DIR}/written/${test}/")
  file(MAKE_DIRECTORY "${folder}")
  set(${environment} "TEST_TMPDIR=${folder}" PARENT_SCOPE)
endfunction()

# halbench_test_parts(gui gui_2x 240 "gui;night" "QT_SCALE_FACTOR=2"): the parts of the program test_gui as tests named
# gui_2x.1 and so on; the time allowed is that of one case, a part has eight times as much, since sanitizers take three.
# The longest start first (COST), or one of them runs alone at the end.
function(halbench_test_parts name prefix timeout labels environment)
  get_target_property(sources test_${name} SOURCES)
  list(LENGTH sources files)
  math(EXPR parts "(${files} + 9) / 10")
  math(EXPR allowed "8 * ${timeout}")
  math(EXPR last "${parts} - 1")
  foreach(part RANGE ${last})
    math(EXPR number "${part} + 1")
    add_test(NAME ${prefix}.${number} COMMAND test_${name} --gtest_brief=1)
    halbench_test_folder(folder ${prefix}.${number})
    set_tests_properties(${prefix}.${number} PROPERTIES TIMEOUT ${allowed} COST ${allowed} LABELS "${labels}"
      ENVIRONMENT "GTEST_TOTAL_SHARDS=${parts};GTEST_SHARD_INDEX=${part};${folder};${environment}")
  endforeach()
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
