#pragma once

#include "app/recordings/recording_name.h"
#include "app/recordings/recording_retention.h"
#include "app/workbench/display_quantity.h"
#include "devices/open/remembered_port.h"

#include <QByteArray>
#include <QHash>
#include <QString>
#include <QStringList>

#include <cstdint>

namespace halbench::app {

constexpr int LongestLockOut_ms = 30000;
constexpr int LeastHistory_GB = 1;
constexpr int MostHistory_GB = 4000;
constexpr int MostKept_GB = 100000;
constexpr std::uint64_t BytesPerGB = 1000000000;

enum class ThemeChoice { System, Light, Dark };

/// What the window remembers between two starts. Kept in the user's configuration folder, never in a project.
struct Preferences {
    ThemeChoice theme = ThemeChoice::System;
    QString language;          ///< "en", "de", "zh_CN"; empty: the system's
    int stopLockOut_ms = 1000; ///< after a stop, how long re-arming is refused
    int historyLimit_GB = 12;  ///< of the disk, for samples that memory has no room for
    QString recordingNames = QString::fromLatin1(DefaultNameMask); ///< mask
    RetentionLimits retention;                                     ///< of recordings so named; off at first
    QStringList retentionFolders; ///< agreedName() of those in which what goes was seen and said yes to
    DisplayUnits units;
    QByteArray geometry;
    QString perspective;
    devices::RememberedPort lastDevice;      ///< the real one that was connected last
    QHash<QString, QByteArray> arrangements; ///< of the panels by perspective, for work without a project
};

/// The limits were confirmed with their plan in this folder. Others in which they were confirmed stay so only
/// while the limits are the same.
void agreeToRetention(Preferences& preferences, const RetentionLimits& limits, const QString& folder);

/// What is damaged or missing keeps its default.
Preferences loadPreferences();
void savePreferences(const Preferences& preferences);

/// "light" or "dark": the choice, or what the system's palette looks like.
QString themeName(ThemeChoice choice);

} // namespace halbench::app
