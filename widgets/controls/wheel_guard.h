#pragma once

#include <QObject>

namespace halbench::widgets {

/// The wheel scrolls the panel under the pointer; it changes a number, a choice or a slider only where that
/// has the focus, and never takes the focus itself. Without it who scrolls past a field changes what is
/// driven, written or computed next. Lives as long as its parent and works in the whole program; it must be
/// there before the fields are.
class WheelGuard : public QObject {
    Q_OBJECT

public:
    explicit WheelGuard(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace halbench::widgets
