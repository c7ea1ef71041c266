#include "app/workbench/departure_text.h"

#include "widgets/language/phrasebook.h"

#include <QCoreApplication>

namespace halbench::app {

namespace {

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::DepartureWords)
};

} // namespace

std::optional<widgets::Message> departureMessage(const DeviceSession& session, const Error& error) {
    if (error.code == ErrorCode::DeviceLost) {
        return widgets::Message{
            widgets::Severity::Error,
            Words::tr("Stopped: connection to the device lost: %1.").arg(widgets::inWords(error.message)),
            Words::tr("The device's watchdog disarms it. Start again after reconnecting."),
            {}};
    }
    if (session.state() != SessionState::Leaving || error.code != ErrorCode::Interrupted) {
        return std::nullopt;
    }
    return widgets::Message{
        widgets::Severity::Information,
        Words::tr("Stopped: the device was disconnected."),
        Words::tr(
            "The device was disarmed first and its settings were restored. Start again after reconnecting."),
        {}};
}

} // namespace halbench::app
