#include "app/workspaces/tune/what_if_recording.h"

#include "app/workbench/shared_results.h"
#include "app/workspaces/tune/tune_messages.h"
#include "app/workspaces/tune/tune_session.h"
#include "app/workspaces/tune/what_if_page.h"
#include "widgets/language/phrasebook.h"

namespace halbench::app {

WhatIfRecording::WhatIfRecording(Workbench& bench, const TuneSession& session, TuneMessages& messages,
                                 WhatIfPage& page, QObject* parent)
    : QObject(parent), m_bench(bench), m_session(session), m_messages(messages), m_page(page) {
    connect(&page, &WhatIfPage::recordingWanted, this, &WhatIfRecording::choose);
    connect(&page, &WhatIfPage::used, this, &WhatIfRecording::take);
    connect(&page, &WhatIfPage::refused, this, &WhatIfRecording::refuse);
}

void WhatIfRecording::choose() {
    if (!m_chooser.open) {
        return;
    }
    const QString path =
        m_chooser.open(&m_page, {tr("Open a recorded move"), {}, tr("Recording (*.csv *.mf4)")});
    if (!path.isEmpty()) {
        use(path);
    }
}

void WhatIfRecording::use(const QString& path) {
    m_pending = path;
    m_page.use(path, {}, m_session.conditions());
}

void WhatIfRecording::chooseGains() {
    const QString path =
        m_chooser.open(&m_page, {tr("Open the active gains of the recording"), {}, tr("Gains (*.json)")});
    if (!path.isEmpty()) {
        m_messages.clear();
        m_page.use(m_pending, path, m_session.conditions());
    }
}

void WhatIfRecording::take(const QString& path) {
    m_pending.clear();
    m_messages.clearError(); // of the recording before, that was refused
    if (!m_bench.identification()) {
        m_messages.show({widgets::Severity::Information,
                         tr("The recording is shown after a motor is identified."),
                         {},
                         {}});
    }
    Q_EMIT used();
    m_bench.session().message(MessageLevel::Info, tr("Tune"), tr("What-if: %1").arg(path));
}

void WhatIfRecording::refuse(const Error& error) {
    if (needsRanFile(error) && m_chooser.open) {
        m_messages.show({widgets::Severity::Error, widgets::inWords(error.message),
                         tr("Choose the file with the gains that were active during the recording."),
                         tr("Recorded gains…")});
    } else {
        m_messages.showError(error);
    }
}

} // namespace halbench::app
