#include "app/workbench/departure_words.h"

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
        return widgets::Message{widgets::Severity::Error,
                                Words::tr("It ended because the connection to the device was lost: %1.")
                                    .arg(widgets::inWords(error.message)),
                                Words::tr("The board's watchdog disarms it by itself. Begin anew when it is "
                                          "connected again."),
                                {}};
    }
    if (session.state() != SessionState::Leaving || error.code != ErrorCode::Interrupted) {
        return std::nullopt;
    }
    return widgets::Message{widgets::Severity::Information,
                            Words::tr("It ended because the device was disconnected."),
                            Words::tr("The board was disarmed first, and everything on it is as it was "
                                      "before. Begin anew when it is connected again."),
                            {}};
}

} // namespace halbench::app
