#include "app/workspaces/drive/path_run.h"

#include "app/documents/pose_table_file.h"
#include "app/documents/text/output_file.h"
#include "app/procedures/excite/travel_reference.h"
#include "app/workbench/drive_ability.h"
#include "app/workbench/drive_control.h"
#include "app/workspaces/drive/path_form.h"
#include "widgets/language/phrasebook.h"

#include <QFileInfo>
#include <QPointer>
#include <QStringList>

#include <limits>

namespace halbench::app {

PathRun::PathRun(Workbench& bench, PathForm& form, QObject* parent)
    : QObject(parent), m_bench(bench), m_form(form) {
    connect(&form, &PathForm::fileWanted, this, &PathRun::chooseTable);
}

Result<std::vector<devices::AxisSpec>> PathRun::movedAxes(const MoveReference& reference) const {
    const devices::Catalogue& catalogue = m_bench.session().catalogue();
    if (isTable(reference)) {
        return tableAxes(catalogue, reference);
    }
    const auto pair = pathAxes(catalogue);
    return pair ? Result<std::vector<devices::AxisSpec>>({pair->front(), pair->back()})
                : failure(pair.error());
}

/// The windows, and where in them each axis is told to be. A value that was not read yet is no limit: the
/// board has it.
std::vector<TableAxisLimits> PathRun::limitsOf(const std::vector<devices::AxisSpec>& axes) const {
    const devices::Catalogue& catalogue = m_bench.session().catalogue();
    const DriveControl& control = m_bench.drive();
    std::vector<TableAxisLimits> limits;
    for (const devices::AxisSpec& axis : axes) {
        const std::string window = parameterOfRole(catalogue, axis.roles.positionWindow);
        const std::string speed = parameterOfRole(catalogue, axis.roles.speedWindow);
        const double from = control.isArmed() ? control.commanded(axis.id) : 0.0;
        constexpr double Unknown = std::numeric_limits<double>::infinity();
        limits.push_back({axis.id,
                          m_bench.deviceValue(window).value_or(Unknown),
                          window,
                          m_bench.deviceValue(speed).value_or(Unknown),
                          speed,
                          {},
                          from});
    }
    return limits;
}

Result<void> PathRun::start() {
    const Result<MoveReference> wanted = m_form.take();
    if (!wanted) {
        return failure(wanted.error());
    }
    const auto axes = movedAxes(*wanted);
    if (!axes) {
        return failure(axes.error());
    }
    if (isTable(*wanted)) {
        if (auto kept = checkTableLimits(*wanted, limitsOf(*axes)); !kept) {
            return kept;
        }
    }
    std::vector<std::string> ids;
    for (const devices::AxisSpec& axis : *axes) {
        ids.push_back(axis.id);
    }
    m_bench.drive().startPath(*wanted, ids);
    return {};
}

/// Read on the thread for files: it may lie on a slow disk.
void PathRun::chooseTable() {
    const QString path =
        m_chooser.open
            ? m_chooser.open(&m_form, {tr("Choose a table of poses"), {}, tr("Tables (*.csv *.txt)")})
            : QString();
    if (path.isEmpty()) {
        return;
    }
    m_files.run(
        [path = path.toStdString(), name = QFileInfo(path).fileName().toStdString()]() -> Result<PoseTable> {
            const Result<std::string> text = readFile(path);
            return text ? parsePoseTable(*text, name) : failure(text.error());
        },
        [form = QPointer<PathForm>(&m_form), path](Result<PoseTable> table) {
            if (form) {
                form->setTable(path, std::move(table));
            }
        });
}

PathRun::Outlook PathRun::outlook() const {
    const Result<MoveReference> wanted = m_form.reference();
    if (!wanted) {
        return {}; // the form says it
    }
    const auto axes = movedAxes(*wanted);
    if (!axes) {
        return {widgets::inWords(axes.error().message) + QLatin1Char(' ') +
                    widgets::inWords(axes.error().hint),
                true};
    }
    const bool isWatched = m_bench.deviceValue("window.position_enabled").value_or(0.0) > 0.5;
    Outlook outlook;
    QStringList titles;
    for (const devices::AxisSpec& axis : *axes) {
        titles.append(QString::fromStdString(axis.title));
    }
    for (const TableAxisLimits& limit : limitsOf(*axes)) {
        const bool isBeyond = referenceExcursion(*wanted, 0.0, limit.axis) > limit.window;
        outlook.isWrong = outlook.isWrong || (isWatched && isBeyond);
    }
    outlook.text = tr("Moves together: %1.").arg(titles.join(QStringLiteral(", ")));
    if (outlook.isWrong) {
        outlook.text += QLatin1Char(' ') + tr("Above the limit: the device may stop.");
    }
    return outlook;
}

} // namespace halbench::app
