#include "devices/system_files.h"

#include "control/base/assert.h"

#include <QtCore/QFile>

// Resources of a static library have to be named once; the macro must stand outside every namespace.
static void initialiseSystemResources() {
    Q_INIT_RESOURCE(system_files);
}

namespace halbench::devices {

std::string udevRules() {
    initialiseSystemResources();
    QFile file(QStringLiteral(":/system/70-halbench.rules"));
    const bool isOpen = file.open(QIODevice::ReadOnly);
    HB_ASSERT(isOpen);
    return file.readAll().toStdString();
}

} // namespace halbench::devices
