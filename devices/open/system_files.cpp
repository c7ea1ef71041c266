#include "devices/open/system_files.h"

#include "control/base/assert.h"

#include <QtCore/QFile>

#include <filesystem>

// Resources of a static library have to be named once; the macro must stand outside every namespace.
static void initialiseSystemResources() {
    Q_INIT_RESOURCE(system_files);
}

namespace halbench::devices {

namespace {

std::string shipped(const QString& name) {
    initialiseSystemResources();
    QFile file(QStringLiteral(":/system/") + name);
    const bool isOpen = file.open(QIODevice::ReadOnly);
    HB_ASSERT(isOpen);
    return file.readAll().toStdString();
}

} // namespace

std::string udevRules() {
    return shipped(QStringLiteral("70-halbench.rules"));
}

std::string desktopFile() {
    std::string text = shipped(QStringLiteral("halbench.desktop"));
    const std::string line = "Exec=halbench\n";
    const std::size_t place = text.find(line);
    std::error_code error;
    const std::string program = std::filesystem::read_symlink("/proc/self/exe", error).string();
    HB_ASSERT(place != std::string::npos);
    if (!error) { // a program that is not installed is in no search path
        text.replace(place, line.size(), "Exec=\"" + program + "\"\n");
    }
    return text;
}

} // namespace halbench::devices
