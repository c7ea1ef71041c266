#pragma once

#include "app/workspaces/workbench.h"
#include "devices/device_watcher.h"

#include <QWidget>

#include <memory>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace halbench::widgets {
class MessageBar;
}

namespace halbench::app {

/// What can be connected, the address in use, the speed of simulated time, and what the device says it is.
class DevicePanel : public QWidget {
    Q_OBJECT

public:
    explicit DevicePanel(Workbench& bench, QWidget* parent = nullptr);

    void setAddress(const QString& uri);
    QString address() const;

public Q_SLOTS:
    void connectAddress();

private:
    void buildChooser();
    void buildIdentity();
    void showDevices(const std::vector<devices::DeviceListing>& list);
    void chooseRow(int row);
    void refresh();
    QString identityText() const;
    void onFailed(const QString& text, const QString& hint);
    Pace chosenPace() const;

    Workbench& m_bench;
    QListWidget* m_list = nullptr;
    QLineEdit* m_address = nullptr;
    QPushButton* m_connect = nullptr;
    QComboBox* m_speed = nullptr;
    QLabel* m_speedLabel = nullptr;
    QLabel* m_identity = nullptr;
    widgets::MessageBar* m_message = nullptr;
    std::unique_ptr<devices::DeviceWatcher> m_watcher; ///< looks for ports, in a thread of its own
};

} // namespace halbench::app
