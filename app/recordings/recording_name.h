#pragma once

#include "control/base/result.h"
#include "devices/device.h"

#include <QtCore/QDateTime>
#include <QtCore/QString>

namespace halbench::app {

/// "sim-htm-1_2026-11-21T21-15-42": sorts by time.
inline constexpr const char* DefaultNameMask = "{device}_{date}T{time}";

/// What a name mask is filled with (resources/help/monitor.md, "Names of recordings").
struct NameParts {
    QString device; ///< serial number, else model; empty: "recording"
    QString name;   ///< as the user wrote it; empty: "recording"
    QDateTime date; ///< on the wall, in UTC
};

/// Serial number, else model, else the kind of its line.
QString recordedDevice(const devices::DeviceInfo& info);

/// A mask that gives legal names: `{device} {name} {date} {time} {number}` between characters that every file
/// system takes. Errors: InvalidInput, naming the character's place.
Result<void> checkNameMask(const QString& mask);

/// What a file system refuses or reads as another folder becomes "-"; names that Windows keeps for itself get
/// a "_". Never empty.
QString legalFileName(const QString& text);

/// The name, without folder and ending, of a recording in `folder`: none of its files exists there yet.
/// `{number}` is one more than the highest there, with at least three digits; without it a taken name gets
/// "-2", "-3" behind it. Numbers and dates are those of the C locale. Errors: of checkNameMask(); OutOfRange
/// (more octets than a file system takes).
Result<QString> recordingName(const QString& mask, const NameParts& parts, const QString& folder);

/// Whether one of the files that a recording of this name has is there, complete or not.
bool isNameTaken(const QString& folder, const QString& name);

} // namespace halbench::app
