#pragma once

#include <QFrame>
#include <QString>
#include <QTimer>

class QLabel;

namespace halbench::widgets {

enum class WorkState { Disconnected, Connected, Armed, Running, Stopped, Fault };

/// The state of the work, said once for the whole window: device, SIMULATED, state with its detail,
/// recording.
class StatusStrip : public QFrame {
    Q_OBJECT
public:
    explicit StatusStrip(QWidget* parent = nullptr);

    /// Detail: the procedure's name when running, why when stopped, what when faulty; else unused.
    void setState(WorkState state, const QString& detail = {});
    /// A latched fault: its symbol blinks slowly, its words stay; not where the desktop's cursor does not
    /// blink.
    void setFaultLatched(bool isLatched);
    void setDevice(const QString& name, bool isSimulated);
    void clearDevice();
    void setRecording(bool isRecording, double elapsed_s = 0.0);

    WorkState state() const { return m_state; }
    QString stateText() const; ///< as shown, e.g. "Stopped (Esc)"

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void refreshSymbol();
    void refreshRecording();

    WorkState m_state = WorkState::Disconnected;
    QString m_detail;
    QString m_device;
    QTimer m_blink;
    bool m_isSymbolShown = true;
    bool m_isSimulated = false;
    bool m_isRecording = false;
    double m_elapsed_s = 0.0;
    QLabel* m_deviceLabel = nullptr;
    QLabel* m_simulatedBadge = nullptr;
    QLabel* m_stateSymbol = nullptr;
    QLabel* m_stateBadge = nullptr;
    QLabel* m_recordSymbol = nullptr;
    QLabel* m_recordLabel = nullptr;
};

} // namespace halbench::widgets
