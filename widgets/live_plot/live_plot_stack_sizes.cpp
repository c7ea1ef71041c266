// How the plots of a stack share its room: by mouse on the lines between them, by key, as they were kept.
#include "widgets/controls/share_splitter.h"
#include "widgets/live_plot/live_plot.h"
#include "widgets/live_plot/live_plot_stack.h"

namespace halbench::widgets {
namespace {

constexpr double Step_ratio = 1.25; ///< of a key

} // namespace

/// As the descriptions of the plots say.
void LivePlotStack::shareRoom() {
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        m_columns[i].rows->setShares(heightsIn(m_specs, static_cast<int>(i)));
    }
    m_splitter->setShares(widthsOf(m_specs));
}

void LivePlotStack::takeHeights(const ShareSplitter& rows) {
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        if (m_columns[i].rows == &rows) {
            setHeights(m_specs, static_cast<int>(i), rows.shares());
        }
    }
}

void LivePlotStack::createSizeActions() {
    addAction(Command::Taller, tr("Taller plot"), QStringLiteral("V"), tr("Increase the plot height"));
    addAction(Command::Shorter, tr("Shorter plot"), QStringLiteral("Shift+V"), tr("Reduce the plot height"));
    addAction(Command::Wider, tr("Wider column"), QStringLiteral("W"), tr("Increase the column width"));
    addAction(Command::Narrower, tr("Narrower column"), QStringLiteral("Shift+W"),
              tr("Reduce the column width"));
    addAction(Command::EqualSizes, tr("Equal sizes"), QStringLiteral("E"),
              tr("Equal widths and heights for all plots"));
}

void LivePlotStack::runOnSizes(Command command) {
    if (command == Command::EqualSizes) {
        m_splitter->shareEvenly();
        for (const Column& column : m_columns) {
            column.rows->shareEvenly();
        }
        return;
    }
    const int column = m_specs[static_cast<std::size_t>(activePlot())].column;
    if (command == Command::Wider || command == Command::Narrower) {
        m_splitter->grow(column, command == Command::Wider ? Step_ratio : 1.0 / Step_ratio);
        return;
    }
    ShareSplitter* rows = m_columns[static_cast<std::size_t>(column)].rows;
    const int at = rows->indexOf(m_rows[static_cast<std::size_t>(activePlot())].box);
    rows->grow(at, command == Command::Taller ? Step_ratio : 1.0 / Step_ratio);
}

} // namespace halbench::widgets
