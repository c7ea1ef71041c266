#pragma once

#include "app/workbench/workbench.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QLabel;

namespace halbench::app {

/// Says when the motor that is known here was identified on another device than the one that is connected. A
/// real device takes the gains of another motor only after a consent of its own, which ends with the device
/// and with the motor; a simulated one cannot be harmed (resources/help/tuning.md). Thread: GUI.
class ForeignMotorNotice : public QWidget {
    Q_OBJECT
public:
    explicit ForeignMotorNotice(Workbench& bench, QWidget* parent = nullptr);

    /// Whether gains for that motor may be written into this device.
    bool isAllowed() const;

Q_SIGNALS:
    void changed();

protected:
    void changeEvent(QEvent* event) override;

private:
    std::optional<Finding> finding() const;
    void forget();
    void refresh();

    Workbench& m_bench;
    QLabel* m_symbol = nullptr;
    QLabel* m_words = nullptr;
    QCheckBox* m_consent = nullptr;
};

} // namespace halbench::app
