#pragma once

#include "app/workbench/drive_control.h"
#include "app/workbench/workbench.h"

#include <QWidget>

#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class QGridLayout;
class QPushButton;

namespace halbench::widgets {
class QuantityEdit;
}

namespace halbench::app {

class HoldButton;

/// Jogging, a pose to go to, and homing for a device with several axes: a row for each axis. With the focus
/// on the pad the left and right arrows jog the first axis, up and down the second, Page Up and Page Down the
/// third, as long as they are held. Thread: GUI.
class PosePad : public QWidget {
    Q_OBJECT
public:
    explicit PosePad(Workbench& bench, QWidget* parent = nullptr);

    /// Axes of the device that is connected; hidden where there is one.
    void refresh();

Q_SIGNALS:
    void refused(const QString& text, const QString& remedy);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    struct Row {
        std::string axis;
        widgets::QuantityEdit* goal;
        HoldButton* back;
        HoldButton* forward;
    };
    void rebuild();
    void addRow(const devices::AxisSpec& axis, int line);
    void jog(std::size_t axis, double sign);
    void goToPose();
    void goOn();
    void sendNext();
    void takePose();
    void home();

    Workbench& m_bench;
    DriveControl& m_control;
    QGridLayout* m_grid = nullptr;
    QPushButton* m_go = nullptr;
    QPushButton* m_here = nullptr;
    QPushButton* m_home = nullptr;
    std::vector<Row> m_rows;
    std::deque<std::pair<std::string, double>> m_way; ///< axes still to be moved, absolute positions
    std::optional<double> m_sent;                     ///< set-point of the axis that is on its way
    bool m_isGoing = false;
    int m_heldKey = 0;
};

} // namespace halbench::app
