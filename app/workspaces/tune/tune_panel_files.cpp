// Gains of the Tune panel out of files and into them.
#include "app/documents/filtered_gains.h"
#include "app/documents/law_code.h"
#include "app/documents/result_documents.h"
#include "app/tuning/gains_judgement.h"
#include "app/workbench/document_files.h"
#include "app/workspaces/tune/tune_panel.h"
#include "widgets/controls/message_bar.h"
#include "widgets/language/phrasebook.h"

#include <QFileInfo>

namespace halbench::app {

/// As `tune --gains` takes them: what is found of their device and timing is told, and the judgement of
/// everything that is proposed decides whether they may be applied.
void TunePanel::openGains() {
    const QString path = m_chooser.open(this, {tr("Open gains"), {}, tr("Gains (*.json)")});
    if (path.isEmpty()) {
        return;
    }
    m_opening.run([path] { return readFilteredGains(path.toStdString()); },
                  [this, path](const Result<GainsFile>& gains) { takeFromFile(path, gains); });
}

void TunePanel::takeFromFile(const QString& path, const Result<GainsFile>& gains) {
    if (!gains) {
        showError(gains.error());
        return;
    }
    if (const auto fits = checkPeriodOfGains(gains->timing, m_conditions.timing); !fits) {
        showError(fits.error());
        return;
    }
    m_shaping.reset();
    useEdited(gains->loopLaw());
    record(tr("Open %1").arg(QFileInfo(path).fileName()));
    ask();
    const DeviceSession& session = m_bench.session();
    const bool isConnected = session.state() == SessionState::Connected;
    const auto foreign = isConnected ? foreignGains(*gains, session.info()) : std::nullopt;
    const auto timing = otherTiming(gains->timing, m_conditions.timing);
    QStringList remarks;
    for (const std::optional<Finding>& finding : {foreign, timing}) {
        remarks += finding ? QStringList(widgets::inWords(finding->message)) : QStringList();
    }
    const auto severity = remarks.empty() ? widgets::Severity::Information : widgets::Severity::Warning;
    m_message->showMessage({severity, tr("Gains of %1.").arg(path), remarks.join(QStringLiteral("; ")), {}});
}

void TunePanel::saveGains() {
    if (!m_shown) {
        return;
    }
    saveText(
        this, m_chooser,
        {tr("Save gains"), QStringLiteral("gains.json"), tr("Gains (*.json);;Control law as C code (*.c)")},
        m_files,
        [header = m_bench.designHeader(), result = *m_shown,
         conditions = m_conditions](const std::string& path) {
            const bool isCode = path.ends_with(".c");
            const LawOrigin origin{result.method, header.device};
            return isCode ? lawCode({result.law, result.filtered}, conditions, origin)
                          : toJsonText(gainsDocument(header, result));
        },
        [this](const QString& path, const Result<void>& written) {
            if (written) {
                m_message->showMessage({widgets::Severity::Success, tr("Saved as %1").arg(path), {}, {}});
            } else {
                showError(written.error());
            }
        });
}

} // namespace halbench::app
