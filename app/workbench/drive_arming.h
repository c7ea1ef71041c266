#pragma once

#include "app/workbench/drive_commands.h"
#include "app/workbench/workbench.h"
#include "devices/device.h"

#include <QObject>

#include <functional>

namespace halbench::app {

/// Arming by hand, disarming and the release of a stop, with the question that is asked once per connection
/// before a real device is armed. Thread: GUI.
class DriveArming : public QObject {
    Q_OBJECT

public:
    DriveArming(Workbench& bench, DriveCommands& commands, QObject* parent = nullptr)
        : QObject(parent), m_bench(bench), m_commands(commands) {}

    bool isAvailable() const;
    bool canDrive() const;
    bool isArmed() const;
    bool isStopped() const;
    bool canRelease() const;
    bool canArm() const;
    bool canDisarm() const;
    bool isNothingToStop() const;

    bool needsConsent() const;
    void askConsent() { m_isAsking = true; }
    void giveConsent();
    void settleConsent();
    /// Another device is asked for anew.
    void forgetConsent();

    /// Refused without consent. `then` runs when the board is armed.
    void arm(devices::BoardMode mode, std::function<void()> then);
    void disarm();
    void releaseStop();
    /// Looks at what the board reports; true when it was armed or disarmed since.
    bool look();

Q_SIGNALS:
    void consentSettled();

private:
    bool isKnownIdle() const;

    Workbench& m_bench;
    DriveCommands& m_commands;
    bool m_hasConsent = false;
    bool m_isAsking = false;
    bool m_wasArmed = false;
};

} // namespace halbench::app
