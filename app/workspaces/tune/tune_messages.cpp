#include "app/workspaces/tune/tune_messages.h"

#include "widgets/language/phrasebook.h"

#include <utility>

namespace halbench::app {

void TuneMessages::showError(const Error& error) {
    show({widgets::Severity::Error, widgets::inWords(error.message), widgets::inWords(error.hint), {}});
}

void TuneMessages::clearError() {
    if (m_bar.message().severity == widgets::Severity::Error) {
        clear();
    }
}

void TuneMessages::showOfDevice(const widgets::Message& message) {
    m_ofDevice = message.text;
    show(message);
}

void TuneMessages::clearOfDevice() {
    if (m_bar.message().text == std::exchange(m_ofDevice, QString())) {
        clear();
    }
}

} // namespace halbench::app
