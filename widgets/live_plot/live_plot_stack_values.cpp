// The axes of values of one plot of a stack, by key: zoom, scroll, fit.
#include "widgets/live_plot/live_plot.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QAction>

namespace halbench::widgets {
namespace {

constexpr double KeyZoom = 1.5; ///< as of the time axis
constexpr double Scroll_ratio = 0.05;
constexpr double CoarseScroll_ratio = 0.25;

} // namespace

void LivePlotStack::createValueActions() {
    addAction(Command::ZoomValuesIn, tr("Zoom the values in"), QStringLiteral("Ctrl++"),
              tr("Zoom in the values of the focused plot"));
    addAction(Command::ZoomValuesOut, tr("Zoom the values out"), QStringLiteral("Ctrl+-"),
              tr("Zoom out the values of the focused plot"));
    addAction(Command::FitValues, tr("Fit the values"), QStringLiteral("Shift+F"),
              tr("Fit the value axes of the focused plot to its data"));
    // Where the plus is above another character, that key alone is meant.
    m_actions.at(Command::ZoomValuesIn)
        ->setShortcuts({QKeySequence(QStringLiteral("Ctrl++")), QKeySequence(QStringLiteral("Ctrl+="))});
}

/// Steps in a row are one of the zoom history, as turns of the wheel are.
void LivePlotStack::showValues(int plot, const ValueRange& left) {
    if (!m_isWheeling) {
        remember();
        m_isWheeling = true;
    }
    m_rows.at(static_cast<std::size_t>(plot)).plot->zoomValues(left);
    m_isDirty = true;
}

void LivePlotStack::runOnValues(Command command) {
    const int plot = activePlot();
    if (command == Command::FitValues) {
        remember();
        m_rows.at(static_cast<std::size_t>(plot)).plot->fitValues();
        m_isDirty = true;
        return;
    }
    const ValueRange shown = valueRange(plot);
    const double middle = 0.5 * (shown.low + shown.high);
    const double half = 0.5 * shown.length() * (command == Command::ZoomValuesIn ? 1.0 / KeyZoom : KeyZoom);
    showValues(plot, {middle - half, middle + half});
}

/// Upwards shows larger values, as scrolling on shows later ones.
void LivePlotStack::scrollValues(int sign, bool isCoarse) {
    const int plot = activePlot();
    const ValueRange shown = valueRange(plot);
    const double by = sign * (isCoarse ? CoarseScroll_ratio : Scroll_ratio) * shown.length();
    showValues(plot, {shown.low + by, shown.high + by});
}

} // namespace halbench::widgets
