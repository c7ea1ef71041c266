#pragma once

#include <QString>

class QLabel;
class QWidget;

namespace halbench::app {

/// A muted explanation beside a result, whose link leads into the help; by keyboard too.
QLabel* noteLabel(QWidget* parent);
/// Hidden when there is nothing to say.
void showNote(QLabel& label, const QString& text);

} // namespace halbench::app
