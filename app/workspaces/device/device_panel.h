#pragma once

#include "app/workbench/file_chooser.h"
#include "app/workbench/workbench.h"
#include "devices/open/device_watcher.h"
#include "devices/open/remembered_port.h"

#include <QWidget>

#include <memory>
#include <vector>

class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QPushButton;
class QVBoxLayout;

namespace halbench::widgets {
class MessageBar;
}

namespace halbench::app {

class SideColumns;

/// Devices that can be connected, the address in use, and the identity that the connected one states; beside
/// them what the window adds to its start page.
class DevicePanel : public QWidget {
    Q_OBJECT

public:
    explicit DevicePanel(Workbench& bench, QWidget* parent = nullptr);

    /// How a description file is asked for; without it there is no button.
    void setFileChooser(FileChooser chooser);

    /// Beside the devices where there is room, else below them.
    void addPart(QWidget& part);

    void setAddress(const QString& uri);
    QString address() const;
    /// What can be connected now: as the list shows it, and its address.
    QList<QPair<QString, QString>> devices() const;

    /// The real device that was connected last, known by its serial number: it is the first in the list,
    /// under the name that its port has now, and chosen until the user chooses. Nothing is opened by itself.
    void setRemembered(const devices::RememberedPort& port);
    const devices::RememberedPort& remembered() const { return m_remembered; }

public Q_SLOTS:
    void connectAddress();
    void toggleConnection();

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct ConnectWords { ///< of the button
        QString text;
        QString tip;
    };

    void buildChooser(QVBoxLayout* column);
    void buildMenu();
    void buildIdentity(QVBoxLayout* column);
    void takeDevices(std::vector<devices::DeviceListing> list);
    void showDevices();
    void addDevice(const devices::DeviceListing& listing, bool isLast);
    static QString textOf(const devices::DeviceListing& listing);
    QListWidgetItem* itemOf(const QString& uri) const;
    void markConnected();
    void fitRows();
    void remember();
    void chooseRow(int row);
    void chooseDescription();
    void editOptions();
    void offerOptions();
    void refresh();
    ConnectWords connectWords() const;
    QString identityText() const;
    void onFailed(const QString& text, const QString& hint);

    Workbench& m_bench;
    SideColumns* m_columns = nullptr;
    QListWidget* m_list = nullptr;
    QLabel* m_noneFound = nullptr; ///< beside the simulated ones
    QLineEdit* m_address = nullptr;
    QPushButton* m_description = nullptr;
    QPushButton* m_options = nullptr; ///< of a simulated device
    FileChooser m_chooser;
    QPushButton* m_connect = nullptr;
    QLabel* m_identity = nullptr;
    widgets::MessageBar* m_message = nullptr;
    std::vector<devices::DeviceListing> m_listed;
    devices::RememberedPort m_remembered;
    bool m_hasChosen = false; ///< the user has: what comes and goes does not choose any more
    std::unique_ptr<devices::DeviceWatcher> m_watcher; ///< looks for ports, in a thread of its own
};

} // namespace halbench::app
