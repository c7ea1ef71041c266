#pragma once

#include "control/base/result.h"
#include "widgets/controls/message_bar.h"

#include <QString>

namespace halbench::app {

/// Messages of the Tune panel in its message bar; those about gains on a device hold only for that device and
/// motor. Thread: GUI.
class TuneMessages {
public:
    /// `bar` outlives it.
    explicit TuneMessages(widgets::MessageBar& bar) : m_bar(bar) {}

    void show(const widgets::Message& message) { m_bar.showMessage(message); }
    void showError(const Error& error);
    void clear() { m_bar.clear(); }
    void clearError(); ///< any other message stays
    void showOfDevice(const widgets::Message& message);
    /// Whether the message that is shown is of a device.
    bool isOfDevice() const { return m_bar.message().text == m_ofDevice; }
    /// Clears that message, unless another one is shown.
    void clearOfDevice();
    /// It stays when the device is gone.
    void keepOfDevice() { m_ofDevice.clear(); }

private:
    widgets::MessageBar& m_bar;
    QString m_ofDevice; ///< its text
};

} // namespace halbench::app
