#pragma once

#include "app/workbench/workbench.h"

#include <QWidget>

#include <memory>
#include <string_view>

class QLabel;
class QVBoxLayout;

namespace halbench::widgets {
class ActuatorPicture;
struct ActuatorView;
} // namespace halbench::widgets

namespace halbench::app {

class LiveMotion;

/// Guide through a motion that is made by hand for a calibration: the picture of the actuator as its board
/// measures it now, with the directions that still lack data, and in words what is missing
/// (resources/help/identification.md section 6). Thread: GUI.
class MotionGuide : public QWidget {
    Q_OBJECT
public:
    explicit MotionGuide(Workbench& bench, QWidget* parent = nullptr);

    /// Whether the calibration of this model of device records a motion made by hand.
    bool isFor(std::string_view model) const;
    /// Starts anew, with the connected device and its settings.
    void begin();
    /// Takes the rows of the procedure, on its thread; nullptr while the device moves itself.
    std::shared_ptr<LiveMotion> motion() const { return m_motion; }
    /// Shows the latest row, and once a second of rows what is missing. Called ten times a second: rows that
    /// stay away for two seconds leave old values.
    void refresh();

private:
    void choosePicture();
    void judge();

    Workbench& m_bench;
    QVBoxLayout* m_column = nullptr;
    const widgets::ActuatorView* m_view = nullptr;
    widgets::ActuatorPicture* m_picture = nullptr; ///< nullptr: the device has none
    QLabel* m_numbers = nullptr;
    QLabel* m_needs = nullptr;
    std::shared_ptr<LiveMotion> m_motion;
    std::size_t m_judgedRows = 0;
    std::size_t m_shownRows = 0;
    int m_idleLooks = 0; ///< since the last new row
};

} // namespace halbench::app
