#include "app/window/start/sample_list.h"

#include "app/window/start/sample_files.h"
#include "app/window/start/start_list.h"
#include "app/workspaces/actuators/registry/sample_recordings.h"
#include "app/workspaces/parts/panel_parts.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/theme_style.h"

#include <QPushButton>
#include <QVBoxLayout>

namespace halbench::app {

SampleList::SampleList(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(widgets::GroupSpacing_px);
    m_list = new StartList({tr("Sample recordings"), {}, tr("Enter or double-click opens a copy")},
                           StartList::Kind::BuiltIn, this);
    std::vector<StartEntry> entries;
    for (const SampleRecording& sample : sampleRecordings()) {
        entries.push_back({sample.file, sample.title, sample.device, sample.title, {}});
    }
    m_list->setEntries(std::move(entries));
    column->addWidget(m_list);
    QPushButton* tour =
        makeButton({tr("Five-minute tour"), tr("Shows the steps from connecting to tuning (Shift+F1)"),
                    QStringLiteral("help")},
                   this);
    column->addWidget(tour, 0, Qt::AlignLeft);
    connect(m_list, &StartList::openRequested, this, &SampleList::open);
    connect(tour, &QPushButton::clicked, this, &SampleList::tourRequested);
}

void SampleList::open(const QString& file) {
    m_files.run([file] { return copySample(file, sampleFolder()); },
                [this](const Result<QString>& path) {
                    if (path) {
                        Q_EMIT recordingChosen(*path);
                    } else {
                        m_list->showError(widgets::inWords(path.error().message),
                                          widgets::inWords(path.error().hint));
                    }
                });
}

} // namespace halbench::app
