#pragma once

#include "app/workbench/workbench.h"

#include <QList>
#include <QPair>
#include <QToolButton>

#include <functional>

namespace halbench::app {

/// Connects the device whose address is in the Devices panel, or one of those its menu lists; disconnects the
/// one that is connected. While a recording is open it leads back to the device that is held.
class ConnectButton : public QToolButton {
    Q_OBJECT

public:
    /// As people read it, and its address.
    using Devices = QList<QPair<QString, QString>>;

    explicit ConnectButton(Workbench& bench, QWidget* parent = nullptr);

    /// Asked whenever the menu opens.
    void setDevices(std::function<Devices()> devices) { m_devices = std::move(devices); }

    int saved_px() const; ///< of its width as an icon alone
    /// Room for either word: nothing beside it moves when it changes.
    QSize sizeHint() const override;

Q_SIGNALS:
    void toggleRequested();
    void deviceChosen(const QString& uri);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void fillMenu();
    void refresh();
    void act();
    bool isRecordingOpen() const;
    bool isDeviceHeld() const;
    QString wordsNow() const;
    QString tipNow() const;
    int words_px() const; ///< of the longer word

    Workbench& m_bench;
    std::function<Devices()> m_devices;
};

} // namespace halbench::app
