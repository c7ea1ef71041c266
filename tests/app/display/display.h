#pragma once

#include <QByteArray>
#include <QProcess>

#include <xcb/xcb.h>

#include <cstdint>

namespace halbench::app {

/// An X server of its own for a test; `screen` as "1920x1200x24".
class Display {
public:
    Display(const char* screen, int density_dpi);
    ~Display();
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    /// Empty when it did not start.
    const QByteArray& name() const { return m_name; }

private:
    QProcess m_server;
    QByteArray m_name;
};

/// What a desktop environment tells its programs by XSETTINGS, on the display of $DISPLAY: here the scale of
/// text and all.
class Desktop {
public:
    explicit Desktop(int density_dpi);
    ~Desktop();
    Desktop(const Desktop&) = delete;
    Desktop& operator=(const Desktop&) = delete;

    void setDensity_dpi(int density_dpi);

private:
    xcb_atom_t atom(const char* name) const;

    xcb_connection_t* m_connection;
    xcb_window_t m_window = 0;
    std::uint32_t m_serial = 0;
};

} // namespace halbench::app
