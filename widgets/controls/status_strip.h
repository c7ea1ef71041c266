#pragma once

#include <QFrame>
#include <QString>
#include <QTimer>

class QLabel;

namespace halbench::widgets {

class ElidedLabel;

enum class WorkState { Disconnected, Connected, Armed, Running, Stopped, Fault };

/// What the samples come from.
enum class SourceKind { Device, Simulation, Recording };

/// The state of the work, said once for the whole window: device, SIMULATED or RECORDING, state with its
/// detail. A recording has no state: nothing in it can be armed or stopped.
class StatusStrip : public QFrame {
    Q_OBJECT
public:
    explicit StatusStrip(QWidget* parent = nullptr);

    /// Detail: the procedure's name when running, what runs by hand when armed, why when stopped, what when
    /// faulty; else unused.
    void setState(WorkState state, const QString& detail = {});
    /// A latched fault: its symbol blinks slowly, its words stay; not where the desktop's cursor does not
    /// blink.
    void setFaultLatched(bool isLatched);
    void setDevice(const QString& name, SourceKind kind);
    void clearDevice();
    /// What can be done about a state, e.g. a stop's release, at the right end; hidden at first. It takes its
    /// room from the words alone: nothing beside the strip moves when it comes, and nothing comes under a
    /// second click on it when it goes.
    void addControl(QWidget& control);
    void setControlShown(bool isShown);

    WorkState state() const { return m_state; }
    QString stateText() const; ///< as shown, e.g. "Stopped (Esc)"

    /// The same for every device and state in a language: nothing beside it moves when they change.
    QSize minimumSizeHint() const override;

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void refreshSymbol();

    WorkState m_state = WorkState::Disconnected;
    QString m_detail;
    QString m_device;
    QTimer m_blink;
    bool m_isSymbolShown = true;
    SourceKind m_kind = SourceKind::Device;
    ElidedLabel* m_deviceLabel = nullptr;
    QLabel* m_kindBadge = nullptr;
    QLabel* m_stateSymbol = nullptr;
    ElidedLabel* m_stateBadge = nullptr;
    QWidget* m_control = nullptr; ///< none until one is added
};

} // namespace halbench::widgets
