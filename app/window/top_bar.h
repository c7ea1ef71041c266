#pragma once

#include "app/window/panels.h"

#include <QHash>
#include <QWidget>

class QAbstractButton;

namespace halbench::widgets {
class StatusStrip;
class StopButton;
} // namespace halbench::widgets

namespace halbench::app {

/// The strip on top of every perspective: state, perspectives, STOP.
class TopBar : public QWidget {
    Q_OBJECT

public:
    explicit TopBar(Workbench& bench, QWidget* parent = nullptr);

    void setPerspective(Perspective perspective);

Q_SIGNALS:
    void stopPressed(); ///< after the stop: for the log
    void perspectiveChosen(halbench::app::Perspective perspective);

private:
    void buildPerspectives();
    void buildRecord();
    void refreshRecording();
    void refresh();
    void rearm();

    Workbench& m_bench;
    widgets::StatusStrip* m_strip = nullptr;
    widgets::StopButton* m_stop = nullptr;
    QAbstractButton* m_record = nullptr;
    QHash<int, QAbstractButton*> m_perspectives;
};

} // namespace halbench::app
