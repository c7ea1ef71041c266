#include "app/workspaces/tune/axes/axis_response_button.h"

#include <QEvent>

#include <utility>

namespace halbench::app {

AxisResponseButton::AxisResponseButton(const AxisLoops& loops, QWidget* parent)
    : QPushButton(parent), m_loops(loops) {
    hide();
    connect(this, &QPushButton::clicked, this, &AxisResponseButton::open);
    refreshWords();
}

void AxisResponseButton::setFileChooser(FileChooser chooser) {
    m_chooser = std::move(chooser);
    setVisible(bool(m_chooser.open));
}

void AxisResponseButton::open() {
    const QString path = m_chooser.open(this, {tr("Open a measured response"), {}, tr("Response (*.json)")});
    if (path.isEmpty()) {
        return;
    }
    m_files.run([path = path.toStdString()] { return readAxesFrequencyFile(path); },
                [this](const Result<AxesFrequencyFile>& file) {
                    const auto plants = file ? m_loops.plantsOf(*file) : failure(file.error());
                    if (plants) {
                        Q_EMIT opened(*plants);
                    } else {
                        Q_EMIT failed(plants.error());
                    }
                });
}

void AxisResponseButton::refreshWords() {
    setText(tr("Measured response\u2026"));
    setAccessibleName(text());
    setToolTip(tr("Show a measured frequency response in the open loops"));
}

void AxisResponseButton::changeEvent(QEvent* event) {
    QPushButton::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

} // namespace halbench::app
