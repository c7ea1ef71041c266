#pragma once

#include "app/window/docks/kept_arrangement.h"
#include "app/window/docks/perspective.h"
#include "widgets/controls/message_bar.h"

namespace halbench::app {

class DockLayout;

/// Says which kept arrangement could not be shown and where it is now. Thread: GUI.
class ArrangementNotice : public widgets::MessageBar {
    Q_OBJECT

public:
    explicit ArrangementNotice(DockLayout& docks, QWidget* parent = nullptr);

private:
    void say(Perspective perspective, ArrangementFault fault, const QString& keptAs);
};

} // namespace halbench::app
