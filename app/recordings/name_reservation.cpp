#include "app/recordings/name_reservation.h"

#include "devices/recording/file_access.h"

#include <QtCore/QDir>

namespace halbench::app {

namespace {

constexpr const char* Ending = ".csv.reserved";

} // namespace

Result<ReservedName> reserveRecordingName(const QString& mask, const NameParts& parts,
                                          const QString& folder) {
    const std::string anyFile = QDir(folder).filePath(QStringLiteral("x")).toStdString();
    if (const Result<void> made = devices::createFolderOf(anyFile); !made) {
        return failure(made.error());
    }
    std::unique_ptr<QLockFile> hold;
    const auto take = [&](const QString& name) {
        if (isNameTaken(folder, name)) {
            return false;
        }
        hold = std::make_unique<QLockFile>(QDir(folder).filePath(name + QLatin1String(Ending)));
        hold->setStaleLockTime(0); // however long it lasts; what a killed program left is seen by its number
        const bool isHeld = hold->tryLock(0);
        // Whoever had it may have begun to write between the two looks.
        return isHeld ? !isNameTaken(folder, name) : hold->error() != QLockFile::LockFailedError;
    };
    const Result<QString> name = firstRecordingName(mask, parts, folder, take);
    return name ? Result<ReservedName>(ReservedName{*name, std::move(hold)}) : failure(name.error());
}

} // namespace halbench::app
