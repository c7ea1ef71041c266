#pragma once

class QAction;
class QToolBar;

namespace halbench::widgets {
class LivePlotStack;
}

namespace halbench::app {

/// The plots' own tools, with their icons, on the Monitor's bar.
void addPlotTools(QToolBar& bar, widgets::LivePlotStack& stack);

/// The tool of an action; but for the most used ones its name is in the tool tip, so that all fit. At the
/// end, or ahead of another.
void addTool(QToolBar& bar, QAction& action, bool hasText, QAction* before = nullptr);

} // namespace halbench::app
