#pragma once

#include "app/window/connect_button.h"
#include "app/window/docks/perspective.h"

#include <QWidget>

class QPushButton;

namespace halbench::widgets {
class StatusStrip;
class StopButton;
} // namespace halbench::widgets

namespace halbench::app {

class ArmButton;
class ModeBox;
class PerspectiveBar;
class RecordButton;

/// The strip on top of every perspective: connection, state, arming and mode, recording, perspectives, STOP.
/// Where it is narrow, first connection and recording show their icons only, then the perspectives are a
/// menu, and last the mode is left to the Drive panel: STOP is in sight from 900 pixels on.
class TopBar : public QWidget {
    Q_OBJECT

public:
    explicit TopBar(Workbench& bench, QWidget* parent = nullptr);

    void setPerspective(Perspective perspective);
    PerspectiveBar& perspectives() { return *m_perspectives; }
    /// A device that only senses has neither Arm nor mode, a recording that is replayed is not recorded.
    void setOffered(bool isDriven, bool isRecorded);
    /// Shows the state and STOP, nothing else.
    void setStateOnly(bool isStateOnly);
    ConnectButton& connection() { return *m_connection; }

    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void stopPressed(); ///< after the stop: for the log
    void perspectiveChosen(halbench::app::Perspective perspective);
    void consentNeeded(); ///< a real actuator is to be armed

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    enum class Room { Wide, Icons, Narrow, Least };

    void buildControls();
    void connectSession();
    void refresh();
    void release();
    int saved_px(Room room) const;
    int needed_px(Room room) const;
    void fit();
    void showControls();

    Workbench& m_bench;
    Room m_room = Room::Wide;
    bool m_isDriven = true;
    bool m_isRecorded = true;
    bool m_isStateOnly = false;
    ConnectButton* m_connection = nullptr;
    widgets::StatusStrip* m_strip = nullptr;
    ArmButton* m_arm = nullptr;
    ModeBox* m_mode = nullptr;
    RecordButton* m_record = nullptr;
    PerspectiveBar* m_perspectives = nullptr;
    QPushButton* m_release = nullptr; ///< of a latched stop; only while there is one
    widgets::StopButton* m_stop = nullptr;
};

} // namespace halbench::app
