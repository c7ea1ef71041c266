# Qwt 6.1.4 ships no CMake package, and one line of its headers is not valid C++20
# (`~QwtSeriesStore<T>()`, rejected by g++ in C++20 mode). The headers are copied into the build tree with
# that one line corrected; the library and its ABI are Debian's.
find_path(QWT_INSTALLED_INCLUDE_DIR qwt_plot.h PATH_SUFFIXES qwt)
find_library(QWT_LIBRARY NAMES qwt-qt5 qwt)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Qwt REQUIRED_VARS QWT_LIBRARY QWT_INSTALLED_INCLUDE_DIR)

if(Qwt_FOUND AND NOT TARGET Qwt::Qwt)
  set(QWT_INCLUDE_DIR ${CMAKE_BINARY_DIR}/qwt_headers)
  file(COPY ${QWT_INSTALLED_INCLUDE_DIR}/ DESTINATION ${QWT_INCLUDE_DIR})
  file(READ ${QWT_INCLUDE_DIR}/qwt_series_store.h QWT_STORE_HEADER)
  string(REPLACE "~QwtSeriesStore<T>()" "~QwtSeriesStore()" QWT_STORE_HEADER "${QWT_STORE_HEADER}")
  file(CONFIGURE OUTPUT ${QWT_INCLUDE_DIR}/qwt_series_store.h CONTENT "${QWT_STORE_HEADER}" @ONLY)
  add_library(Qwt::Qwt UNKNOWN IMPORTED)
  set_target_properties(Qwt::Qwt PROPERTIES
    IMPORTED_LOCATION ${QWT_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${QWT_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES "Qt5::Widgets;Qt5::Svg")
endif()
