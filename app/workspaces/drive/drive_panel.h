#pragma once

#include "app/workbench/drive_control.h"
#include "app/workbench/file_chooser.h"
#include "app/workbench/workbench.h"
#include "app/workspaces/parts/focus_keeper.h"

#include <QTimer>
#include <QWidget>

class QComboBox;
class QGroupBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace halbench::widgets {
class ElidedLabel;
class MessageBar;
class QuantityEdit;
} // namespace halbench::widgets

namespace halbench::app {

class DriveLimits;
class JogRow;
class PathRun;
class PosePad;
class ReferenceForm;

/// Moving the actuator by hand: arm, mode, set-point, jog, reference generator, limits, faults in words
/// (resources/help/monitor.md, "Drive").
class DrivePanel : public QWidget {
    Q_OBJECT

public:
    explicit DrivePanel(Workbench& bench, QWidget* parent = nullptr);
    ~DrivePanel() override;
    void setFileChooser(FileChooser chooser);

protected:
    void changeEvent(QEvent* event) override;

private:
    void buildArm(QVBoxLayout* column);
    void buildSetpoint(QVBoxLayout* column);
    void buildReference(QVBoxLayout* column);
    void buildLimits(QVBoxLayout* column);
    void onMessageAction();
    void endQuestion();
    void showOrigin();
    void showSetpoint();
    void onSetpoint();
    void onSetpointRefused(const QString& text);
    void onStartReference();
    void sayMotion(const QString& words, bool isWarning);
    void refresh();
    void refreshStop();
    void refreshMode();
    void refreshAxes();
    std::string unit() const; ///< SI, of the set-point
    void refreshState();
    void refreshUnits();
    void dressSetpoint();
    double factor() const; ///< of the set-point: shown over rad or A
    QString valueText(double value) const;
    void onUnits();
    void refreshLive();
    static QString startHelp();
    void takePeak();
    void describeMotion();
    double commanded_rad() const; ///< from where it was armed
    void forgetError();
    void showError(const QString& text, const QString& remedy);

    enum class Asking { Nothing, Consent, Release };

    Workbench& m_bench;
    DriveControl& m_control;
    Asking m_asking = Asking::Nothing;
    bool m_isJustRefused = false; ///< a set-point, in this turn of the event loop
    bool m_isGoRefused = false;   ///< the press of Go that made its text leave the field
    bool m_wasArmed = false;
    devices::BoardMode m_shownMode; ///< whose units the fields have
    std::string m_shownAxis;        ///< likewise
    DisplayUnits m_units;           ///< that they show
    QTimer m_frame;                 ///< ten times a second
    widgets::MessageBar* m_message = nullptr;
    widgets::ElidedLabel* m_state; ///< of the board
    FocusKeeper m_rest;            ///< there
    double m_peak = 0.0;           ///< of the reference that Start would send
    double m_shownSetpoint = 0.0;  ///< the one that the field has followed
    QWidget* m_axisRow = nullptr;
    QComboBox* m_axes = nullptr;
    QLabel* m_from = nullptr; ///< what the set-point counts from
    widgets::QuantityEdit* m_setpoint = nullptr;
    QPushButton* m_go = nullptr;
    QPushButton* m_zero = nullptr;
    QLabel* m_setpointNow = nullptr;
    JogRow* m_jog = nullptr;
    PosePad* m_pose = nullptr;
    ReferenceForm* m_reference = nullptr;
    PathRun* m_path = nullptr;
    QLabel* m_motion = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_end = nullptr;
    DriveLimits* m_limits = nullptr;
};

} // namespace halbench::app
