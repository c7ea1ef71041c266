# One precompiled header a layer: the standard library and the libraries that most of the layer's sources read anyway (two
# thirds of the time of a compilation went into reading them). Our own headers are in none: a change would compile all anew.
# A header is made with the fewest definitions that its users share; what a user defines beyond them does no harm.
set(precompiled_standard <algorithm> <array> <atomic> <charconv> <chrono> <cmath> <complex> <cstddef> <cstdint> <cstring>
  <deque> <functional> <limits> <map> <memory> <mutex> <numbers> <numeric> <optional> <set> <span> <string> <string_view>
  <thread> <utility> <variant> <vector> <fmt/format.h> <tl/expected.hpp>)
set(precompiled_numbers <Eigen/Core> <Eigen/Cholesky> <Eigen/Eigenvalues> <Eigen/LU> <Eigen/QR>)
set(precompiled_devices <Eigen/Core> <QtCore/QtCore>)
set(precompiled_window <QtCore/QtCore> <QtGui/QtGui> <QtWidgets/QtWidgets>)
set(precompiled_tests <gtest/gtest.h> <filesystem> <fstream> <random> <sstream>)

# halbench_precompiled(window Qt5::Widgets): the headers `window` and `tests_window`, made with what is given.
function(halbench_precompiled layer)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/precompiled.cpp CONTENT "// Carries a precompiled header.\n")
  foreach(name ${layer} tests_${layer})
    add_library(precompiled_${name} OBJECT EXCLUDE_FROM_ALL ${CMAKE_BINARY_DIR}/precompiled.cpp)
    target_link_libraries(precompiled_${name} PRIVATE halbench_options halbench_expected fmt::fmt Eigen3::Eigen ${ARGN})
    target_precompile_headers(precompiled_${name} PRIVATE ${precompiled_standard} ${precompiled_${layer}})
  endforeach()
  target_link_libraries(precompiled_tests_${layer} PRIVATE halbench_test_options GTest::gtest)
  target_precompile_headers(precompiled_tests_${layer} PRIVATE ${precompiled_tests})
endfunction()

# Tests are compiled in half the time when they are not optimised much; what they test is optimised as it is shipped.
add_library(halbench_test_options INTERFACE)
target_compile_options(halbench_test_options INTERFACE -O1)
