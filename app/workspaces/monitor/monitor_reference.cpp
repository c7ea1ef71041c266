#include "app/workspaces/monitor/monitor_reference.h"

#include "devices/formats/recording_file.h"
#include "widgets/language/phrasebook.h"
#include "widgets/live_plot/live_plot_stack.h"
#include "widgets/live_plot/reference_traces.h"
#include "widgets/theme/icons.h"

#include <QAction>
#include <QFileInfo>
#include <QMenu>
#include <QWidget>

#include <algorithm>

namespace halbench::app {

namespace {

/// The event of a recording that waited for one, else where its record button was pressed.
std::optional<double> eventOf(const devices::RecordingMeta& meta) {
    for (const char* name : {"trigger", "record"}) {
        const auto found = std::find_if(meta.markers.begin(), meta.markers.end(),
                                        [&](const auto& marker) { return marker.text == name; });
        if (found != meta.markers.end()) {
            return found->time_s;
        }
    }
    return std::nullopt;
}

struct ReadReference {
    widgets::ReferencePtr traces;
    std::vector<std::string> warnings;
};

Result<ReadReference> readReference(const QString& path) {
    const Result<devices::RecordedFile> file = devices::readRecordingFile(path.toStdString());
    if (!file) {
        return failure(file.error());
    }
    widgets::ReferenceTraces traces = widgets::tracesOf(file->recording);
    traces.event_s = eventOf(file->meta);
    traces.name = QFileInfo(path).fileName();
    return ReadReference{std::make_shared<const widgets::ReferenceTraces>(std::move(traces)), file->warnings};
}

} // namespace

MonitorReference::MonitorReference(widgets::LivePlotStack& stack, QWidget& panel)
    : QObject(&panel), m_stack(stack), m_panel(panel) {
    m_open = new QAction(widgets::themedIcon(QStringLiteral("open")), tr("Recording as reference…"), &panel);
    m_open->setShortcut(QKeySequence(QStringLiteral("Ctrl+K")));
    m_open->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    m_open->setToolTip(
        QStringLiteral("%1 (%2)").arg(tr("Show a recording below the curves, aligned at trigger or start"),
                                      m_open->shortcut().toString(QKeySequence::NativeText)));
    panel.addAction(m_open);
    connect(m_open, &QAction::triggered, this, &MonitorReference::open);
    auto* menu = new QMenu(&panel);
    menu->addAction(stack.action(widgets::LivePlotStack::Command::KeepReference));
    menu->addAction(m_open);
    menu->addAction(stack.action(widgets::LivePlotStack::Command::RemoveReference));
    m_menuAction = new QAction(widgets::themedIcon(QStringLiteral("reference")), tr("Reference"), &panel);
    m_menuAction->setToolTip(tr("Reference curves: keep the view (K), a recording (Ctrl+K), none (Shift+K)"));
    m_menuAction->setMenu(menu);
}

void MonitorReference::open() {
    const QString path =
        m_chooser.open
            ? m_chooser.open(&m_panel, {tr("Recording as reference"), {}, tr("Recording (*.csv *.mf4)")})
            : QString();
    if (path.isEmpty()) {
        return;
    }
    m_files.run([path] { return readReference(path); },
                [this](const Result<ReadReference>& read) {
                    if (read) {
                        m_stack.setReference(read->traces);
                        for (const std::string& warning : read->warnings) {
                            Q_EMIT doubted(widgets::inWords(warning));
                        }
                    } else {
                        Q_EMIT failed(widgets::inWords(read.error().message),
                                      widgets::inWords(read.error().hint));
                    }
                });
}

} // namespace halbench::app
