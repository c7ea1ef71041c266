#pragma once

#include "tests/widgets/live_data.h"
#include "widgets/figure/offscreen_application.h"
#include "widgets/live_plot/live_legend.h"
#include "widgets/live_plot/live_plot.h"
#include "widgets/live_plot/live_plot_stack.h"
#include "widgets/theme/theme_style.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace halbench::widgets {

/// A shown stack of the motor's five plots with 30 s of data.
class LivePlotStackTest : public testing::Test {
protected:
    LivePlotStackTest() {
        appendMotor(history, 30.0);
        stack.setTheme(loadTheme("light").value());
        stack.setHistory(&history);
        stack.setPlots(motorPlots());
        stack.resize(1200, 900);
        stack.show();
        frame();
    }
    void frame() {
        QApplication::processEvents();
        stack.refresh();
        QApplication::processEvents();
    }
    template <typename Widget>
    std::vector<Widget*> fromTopToBottom() const {
        std::vector<Widget*> sorted;
        for (Widget* widget : stack.findChildren<Widget*>()) {
            if (widget->isVisible()) { // removed ones wait for the event loop to be deleted
                sorted.push_back(widget);
            }
        }
        std::sort(sorted.begin(), sorted.end(), [this](const Widget* left, const Widget* right) {
            return left->mapTo(&stack, QPoint()).y() < right->mapTo(&stack, QPoint()).y();
        });
        return sorted;
    }
    std::vector<LivePlot*> plots() const { return fromTopToBottom<LivePlot>(); }
    std::vector<LiveLegend*> legends() const { return fromTopToBottom<LiveLegend>(); }
    void key(int code, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QKeyEvent press(QEvent::KeyPress, code, modifiers);
        QApplication::sendEvent(plots().front(), &press);
        frame();
    }
    void trigger(LivePlotStack::Command command) {
        stack.action(command)->trigger();
        frame();
    }
    void mouse(LivePlot* plot, QEvent::Type type, QPoint place, Qt::MouseButton button,
               Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QMouseEvent event(type, place, button, button, modifiers);
        QApplication::sendEvent(plot->canvas(), &event);
    }
    void drag(LivePlot* plot, QPoint from, QPoint to, Qt::MouseButton button,
              Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        mouse(plot, QEvent::MouseButtonPress, from, button, modifiers);
        mouse(plot, QEvent::MouseMove, (from + to) / 2, button, modifiers);
        mouse(plot, QEvent::MouseMove, to, button, modifiers);
        mouse(plot, QEvent::MouseButtonRelease, to, button, modifiers);
        frame();
    }
    void wheel(LivePlot* plot, QPoint place, int steps, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QWheelEvent event(place, plot->canvas()->mapToGlobal(place), QPoint(), QPoint(0, 120 * steps),
                          Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
        QApplication::sendEvent(plot->canvas(), &event);
        frame();
    }

    Result<OffscreenApplication> application = OffscreenApplication::ensure();
    control::SampleHistory history{std::size_t{1} << 28};
    LivePlotStack stack;
};

} // namespace halbench::widgets
