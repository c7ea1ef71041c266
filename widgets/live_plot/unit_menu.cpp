#include "widgets/live_plot/unit_menu.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>

namespace halbench::widgets {
namespace {

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::widgets::UnitMenu)
};

/// A ratio has no unit.
QString unitWords(const UnitChoice& choice) {
    const QString unit = choice.text.isEmpty() ? QStringLiteral("1") : choice.text;
    return choice.key.empty() ? Words::tr("Default of the preferences (%1)").arg(unit) : unit;
}

} // namespace

QMenu* unitMenu(const PlotCurve& curve, QWidget& parent,
                const std::function<void(const std::string&)>& choose) {
    if (curve.unitChoices.empty()) {
        return nullptr;
    }
    auto* menu = new QMenu(&parent);
    menu->setAccessibleName(Words::tr("Unit of %1").arg(nameOf(curve)));
    auto* group = new QActionGroup(menu);
    for (const UnitChoice& choice : curve.unitChoices) {
        QAction* action = menu->addAction(unitWords(choice));
        action->setCheckable(true);
        group->addAction(action);
        action->setChecked(choice.key == curve.ownUnit);
        if (action->isChecked()) {
            menu->setActiveAction(action);
        }
        QObject::connect(action, &QAction::triggered, menu, [choose, key = choice.key] { choose(key); });
    }
    return menu;
}

} // namespace halbench::widgets
