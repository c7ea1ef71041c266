#include "tests/app/display/display.h"

#include <QDataStream>

#include <cstdlib>
#include <cstring>

namespace halbench::app {

Display::Display(const char* screen, int density_dpi) {
    m_server.setStandardErrorFile(QProcess::nullDevice());
    m_server.start("Xvfb", {"-displayfd", "1", "-nolisten", "tcp", "-dpi", QString::number(density_dpi),
                            "-screen", "0", screen});
    if (m_server.waitForStarted() && m_server.waitForReadyRead()) {
        m_name = ":" + m_server.readLine().trimmed();
    }
}

Display::~Display() {
    m_server.terminate();
    m_server.waitForFinished();
}

Desktop::Desktop(int density_dpi) : m_connection(xcb_connect(nullptr, nullptr)) {
    const xcb_screen_t* screen = xcb_setup_roots_iterator(xcb_get_setup(m_connection)).data;
    m_window = xcb_generate_id(m_connection);
    xcb_create_window(m_connection, XCB_COPY_FROM_PARENT, m_window, screen->root, 0, 0, 1, 1, 0,
                      XCB_WINDOW_CLASS_INPUT_OUTPUT, screen->root_visual, 0, nullptr);
    setDensity_dpi(density_dpi);
    xcb_set_selection_owner(m_connection, m_window, atom("_XSETTINGS_S0"), XCB_CURRENT_TIME);
    xcb_flush(m_connection);
}

Desktop::~Desktop() {
    xcb_disconnect(m_connection);
}

/// One setting of the type integer, in the form of the XSETTINGS specification 0.5.
void Desktop::setDensity_dpi(int density_dpi) {
    constexpr int FixedPoint = 1024; // of Xft/DPI
    QByteArray settings;
    QDataStream stream(&settings, QIODevice::WriteOnly); // most significant octet first
    const QByteArray name = "Xft/DPI";
    stream << quint8(1) << quint8(0) << quint16(0) << quint32(++m_serial) << quint32(1);
    stream << quint8(0) << quint8(0) << quint16(name.size());
    stream.writeRawData(name.constData(), name.size());
    stream << quint8(0); // the name ends at a multiple of four octets
    stream << quint32(m_serial) << qint32(density_dpi * FixedPoint);
    const xcb_atom_t property = atom("_XSETTINGS_SETTINGS");
    xcb_change_property(m_connection, XCB_PROP_MODE_REPLACE, m_window, property, property, 8,
                        static_cast<std::uint32_t>(settings.size()), settings.constData());
    xcb_flush(m_connection);
}

xcb_atom_t Desktop::atom(const char* name) const {
    const auto asked = xcb_intern_atom(m_connection, 0, static_cast<std::uint16_t>(std::strlen(name)), name);
    xcb_intern_atom_reply_t* reply = xcb_intern_atom_reply(m_connection, asked, nullptr);
    const xcb_atom_t atom = reply == nullptr ? 0 : reply->atom;
    std::free(reply);
    return atom;
}

} // namespace halbench::app
