#include "app/workspaces/tune/gain_files.h"

#include "app/documents/filtered_gains.h"
#include "app/documents/law_code.h"
#include "app/documents/result_documents.h"
#include "app/tuning/gains_judgement.h"
#include "app/workbench/document_files.h"
#include "app/workbench/shared_results.h"
#include "app/workspaces/tune/tune_session.h"
#include "widgets/controls/message_bar.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QToolButton>

#include <optional>
#include <utility>

namespace halbench::app {

GainFiles::GainFiles(Workbench& bench, const TuneSession& session, QWidget* parent)
    : QWidget(parent), m_bench(bench), m_session(session), m_save(new QToolButton(this)),
      m_open(new QToolButton(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(widgets::PanelMargin_px);
    m_save->setIcon(widgets::themedIcon(QStringLiteral("save"))); // icons: words do not fit the width
    m_open->setIcon(widgets::themedIcon(QStringLiteral("open")));
    for (QToolButton* button : {m_save, m_open}) {
        row->addWidget(button);
        button->hide();
    }
    connect(m_save, &QToolButton::clicked, this, &GainFiles::save);
    connect(m_open, &QToolButton::clicked, this, &GainFiles::open);
    refreshTexts();
}

void GainFiles::setFileChooser(FileChooser chooser) {
    m_chooser = std::move(chooser);
    m_save->setVisible(bool(m_chooser.save));
    m_open->setVisible(bool(m_chooser.open));
}

void GainFiles::setCanSave(bool canSave) {
    m_save->setEnabled(canSave);
}

/// As `tune --gains` takes them: the judgement of everything that is proposed decides whether they may be
/// applied.
void GainFiles::open() {
    const QString path = m_chooser.open(this, {tr("Open gains"), {}, tr("Gains (*.json)")});
    if (path.isEmpty()) {
        return;
    }
    m_opening.run([path] { return readFilteredGains(path.toStdString()); },
                  [this, path](const Result<GainsFile>& gains) { take(path, gains); });
}

void GainFiles::take(const QString& path, const Result<GainsFile>& gains) {
    if (!gains) {
        Q_EMIT failed(gains.error());
        return;
    }
    const control::LoopTiming& timing = m_session.conditions().timing;
    if (const auto fits = checkPeriodOfGains(gains->timing, timing); !fits) {
        Q_EMIT failed(fits.error());
        return;
    }
    Q_EMIT opened(gains->loopLaw(), QFileInfo(path).fileName());
    const DeviceSession& session = m_bench.session();
    const bool isConnected = session.state() == SessionState::Connected;
    const auto foreign = isConnected ? foreignGains(*gains, session.info()) : std::nullopt;
    QStringList remarks;
    for (const std::optional<Finding>& finding : {foreign, otherTiming(gains->timing, timing)}) {
        remarks += finding ? QStringList(widgets::inWords(finding->message)) : QStringList();
    }
    const auto severity = remarks.empty() ? widgets::Severity::Information : widgets::Severity::Warning;
    Q_EMIT told({severity, tr("Gains of %1.").arg(path), remarks.join(QStringLiteral("; ")), {}});
}

void GainFiles::save() {
    if (!m_session.proposed()) {
        return;
    }
    saveText(
        this, m_chooser,
        {tr("Save gains"), QStringLiteral("gains.json"), tr("Gains (*.json);;Control law as C code (*.c)")},
        m_files,
        [header = m_bench.designHeader(), result = *m_session.proposed(),
         conditions = m_session.conditions()](const std::string& path) {
            const bool isCode = path.ends_with(".c");
            const LawOrigin origin{result.method, header.device};
            return isCode ? lawCode({result.law, result.filtered}, conditions, origin)
                          : toJsonText(gainsDocument(header, result));
        },
        [this](const QString& path, const Result<void>& written) {
            if (written) {
                Q_EMIT told({widgets::Severity::Success, tr("Saved as %1").arg(path), {}, {}});
            } else {
                Q_EMIT failed(written.error());
            }
        });
}

void GainFiles::refreshTexts() {
    const auto name = [](QToolButton& button, const QString& words, const QString& help) {
        button.setText(words);
        button.setAccessibleName(words);
        button.setToolTip(help);
    };
    name(*m_save, tr("Save gains\u2026"), tr("Save gains to a file"));
    name(*m_open, tr("Open gains\u2026"),
         tr("Use the gains of a file as proposed gains; they are assessed before they can be applied"));
}

void GainFiles::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshTexts();
    }
}

} // namespace halbench::app
