#pragma once

class QAction;
class QWidget;

namespace halbench::widgets {

/// Gives a view of a picture what all have: the focus, a context menu with both actions, their icons, and
/// their keys while it has the focus (copy, Ctrl+E). The words are the view's own.
void addPictureActions(QWidget& view, QAction& copy, QAction& save);

} // namespace halbench::widgets
