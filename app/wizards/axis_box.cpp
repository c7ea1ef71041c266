#include "app/wizards/axis_box.h"

#include "app/procedures/base/axis_choice.h"

#include <QComboBox>
#include <QSignalBlocker>

namespace halbench::app {

void fillAxisBox(QComboBox& box, const devices::Catalogue& catalogue, const QString& all) {
    const QSignalBlocker quiet(box);
    box.clear();
    box.addItem(all, QStringLiteral("all"));
    for (const devices::AxisSpec& axis : axesOf(catalogue)) {
        box.addItem(QString::fromStdString(axis.title), QString::fromStdString(axis.id));
    }
}

} // namespace halbench::app
