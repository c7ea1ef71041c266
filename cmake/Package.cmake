# `./dev package`: a Debian package whose dependencies come from the program itself.
include(GNUInstallDirs)
install(TARGETS halbench RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY resources/experiments resources/presets resources/schemas resources/help
  DESTINATION ${CMAKE_INSTALL_DATADIR}/halbench OPTIONAL)
install(FILES resources/system/70-halbench.rules DESTINATION lib/udev/rules.d)
install(FILES resources/system/halbench.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME halbench)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "Halbench maintainers <maintainers@halbench.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "workstation for precision Lorentz-force actuators")
set(CPACK_PACKAGE_DESCRIPTION
"Halbench watches, identifies and retunes ironless Halbach-array actuators: it
measures viscous damping, Coulomb friction and torque constant with intervals,
designs the position controller, applies it as one transaction and verifies the
motion, by hand or without a display in continuous integration.")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "fonts-dejavu-core, fonts-noto-cjk, qttranslations5-l10n")
include(CPack)
