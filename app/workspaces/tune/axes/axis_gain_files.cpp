#include "app/workspaces/tune/axes/axis_gain_files.h"

#include "app/workbench/document_files.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QToolButton>

#include <utility>

namespace halbench::app {

AxisGainFiles::AxisGainFiles(std::function<Result<JsonValue>()> document, QWidget* parent)
    : QWidget(parent), m_document(std::move(document)), m_save(new QToolButton(this)),
      m_open(new QToolButton(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(widgets::PanelMargin_px);
    m_save->setIcon(widgets::themedIcon(QStringLiteral("save"))); // icons, as in the panel of a single loop
    m_open->setIcon(widgets::themedIcon(QStringLiteral("open")));
    for (QToolButton* button : {m_save, m_open}) {
        row->addWidget(button);
        button->hide();
    }
    connect(m_save, &QToolButton::clicked, this, &AxisGainFiles::save);
    connect(m_open, &QToolButton::clicked, this, &AxisGainFiles::open);
    refreshWords();
}

void AxisGainFiles::setFileChooser(FileChooser chooser) {
    m_chooser = std::move(chooser);
    m_save->setVisible(bool(m_chooser.save));
    m_open->setVisible(bool(m_chooser.open));
}

void AxisGainFiles::setUsable(bool canOpen, bool canSave) {
    m_open->setEnabled(canOpen);
    m_save->setEnabled(canSave);
}

widgets::Message AxisGainFiles::openedMessage(const QString& path, const std::vector<std::string>& missing) {
    QStringList names;
    for (const std::string& axis : missing) {
        names << QString::fromStdString(axis);
    }
    const QString title = tr("Gains of %1.").arg(path);
    if (names.empty()) {
        return {widgets::Severity::Information, title, {}, {}};
    }
    return {widgets::Severity::Warning,
            title,
            tr("It has none for %1, which keep their own.").arg(names.join(QStringLiteral(", "))),
            {}};
}

void AxisGainFiles::open() {
    const QString path = m_chooser.open(this, {tr("Open gains"), {}, tr("Gains (*.json)")});
    if (path.isEmpty()) {
        return;
    }
    m_files.run([path = path.toStdString()] { return readAxisGains(path); },
                [this, path](const Result<AxisGainsFile>& gains) {
                    if (gains) {
                        Q_EMIT opened(path, *gains);
                    } else {
                        Q_EMIT failed(gains.error());
                    }
                });
}

void AxisGainFiles::save() {
    const Result<JsonValue> document = m_document();
    if (!document) {
        Q_EMIT failed(document.error());
        return;
    }
    saveDocument(
        this, m_chooser, {tr("Save gains"), QStringLiteral("gains.json"), tr("Gains (*.json)")}, m_files,
        [document = *document] { return document; },
        [this](const QString& path, const Result<void>& written) {
            if (written) {
                Q_EMIT saved(path);
            } else {
                Q_EMIT failed(written.error());
            }
        });
}

void AxisGainFiles::refreshWords() {
    const auto name = [](QToolButton& button, const QString& words, const QString& help) {
        button.setText(words);
        button.setAccessibleName(words);
        button.setToolTip(help);
    };
    name(*m_save, tr("Save gains\u2026"), tr("Save the gains of all axes to a file"));
    name(*m_open, tr("Open gains\u2026"), tr("Propose the gains of a file; they are assessed first"));
}

void AxisGainFiles::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

} // namespace halbench::app
