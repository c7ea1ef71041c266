#pragma once

#include "app/window/tour/tour_steps.h"
#include "app/workbench/workbench.h"

#include <QObject>
#include <QPointer>

class QAction;
class QMainWindow;
class QMenu;

namespace halbench::app {

class DockLayout;
class TourCard;
class TourFrame;

/// The five-minute tour through the window: raises the panel of each step, frames it and shows a card beside
/// it. It connects, arms and starts nothing. Steps whose panel the open device does not have are skipped, and
/// that of connecting once a device is there. Thread: GUI.
class Tour : public QObject {
    Q_OBJECT

public:
    /// After the panels are there.
    Tour(QMainWindow& window, DockLayout& docks, DeviceSession& session);

    /// Starts the tour; while it runs, switches the focus between its card and the panel of the step.
    void addTo(QMenu& menu);
    void start();
    void next();
    void back();
    void leave();
    bool isRunning() const { return m_isRunning; }
    const TourStep& step() const { return m_steps[m_now]; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void startOrSwitch();
    void show(std::size_t step);
    void setWords();
    void follow();
    void place();
    void watch(QWidget* target);
    std::vector<TourStep> offeredSteps() const;
    QWidget* target() const;
    QRect room() const;
    QRect targetPlace(const QWidget& target) const;

    QMainWindow& m_window;
    DockLayout& m_docks;
    DeviceSession& m_session;
    QMenu* m_menu = nullptr; ///< which the last step points at
    TourCard* m_card = nullptr;
    QPointer<TourFrame> m_frame; ///< goes with a floating panel that is deleted
    QPointer<QWidget> m_target;  ///< whose place is watched
    std::vector<TourStep> m_steps;
    std::size_t m_now = 0;
    bool m_isRunning = false;
};

} // namespace halbench::app
