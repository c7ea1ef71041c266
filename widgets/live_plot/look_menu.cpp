#include "widgets/live_plot/look_menu.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QMenu>
#include <QPainter>
#include <QPixmap>

#include <array>

namespace halbench::widgets {
namespace {

constexpr QSize Sample{18, 12};
constexpr double SampleLine = 2.0;

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::widgets::LookMenu)
};

/// In the order of Theme::curves, the same hues in all themes.
std::array<QString, 8> colourWords() {
    return {Words::tr("Blue"),   Words::tr("Orange"), Words::tr("Green"),      Words::tr("Pink"),
            Words::tr("Purple"), Words::tr("Ochre"),  Words::tr("Light blue"), Words::tr("Grey")};
}

std::array<QString, 4> lineWords() {
    return {Words::tr("Solid"), Words::tr("Dashed"), Words::tr("Dotted"), Words::tr("Dash-dot")};
}

QIcon sample(const QColor& colour, LinePattern pattern) {
    const double ratio = qGuiApp->devicePixelRatio();
    QPixmap picture(Sample * ratio);
    picture.setDevicePixelRatio(ratio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setPen(curvePen(colour, pattern, SampleLine));
    painter.drawLine(QPointF(0.0, Sample.height() / 2.0), QPointF(Sample.width(), Sample.height() / 2.0));
    painter.end();
    return picture;
}

QAction* addChoice(QMenu& menu, QActionGroup& group, const QString& text, bool isChosen) {
    QAction* action = menu.addAction(text);
    action->setCheckable(true);
    action->setChecked(isChosen);
    group.addAction(action);
    if (isChosen) {
        menu.setDefaultAction(action); // in bold: beside an icon the style draws no mark
    }
    return action;
}

} // namespace

QMenu* colourMenu(const HistoryCurve& curve, const Theme& theme, QWidget& parent,
                  const std::function<void(std::optional<int>)>& choose) {
    auto* menu = new QMenu(Words::tr("Colour"), &parent);
    menu->setAccessibleName(Words::tr("Colour of %1").arg(nameOf(curve.curve())));
    auto* group = new QActionGroup(menu);
    const std::array<QString, 8> words = colourWords();
    for (std::size_t i = 0; i < words.size(); ++i) {
        QAction* action = addChoice(*menu, *group, words[i], curve.colour() == theme.curves[i]);
        action->setIcon(sample(theme.curves[i], curve.pattern()));
        QObject::connect(action, &QAction::triggered, menu,
                         [choose, i] { choose(std::optional(static_cast<int>(i))); });
    }
    menu->addSeparator();
    QObject::connect(menu->addAction(Words::tr("Automatic colour and line")), &QAction::triggered, menu,
                     [choose] { choose(std::nullopt); });
    return menu;
}

QMenu* lineMenu(const HistoryCurve& curve, const Theme& theme, QWidget& parent,
                const std::function<void(LinePattern)>& choose) {
    auto* menu = new QMenu(Words::tr("Line"), &parent);
    menu->setAccessibleName(Words::tr("Line of %1").arg(nameOf(curve.curve())));
    auto* group = new QActionGroup(menu);
    const std::array<QString, 4> words = lineWords();
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto pattern = static_cast<LinePattern>(i);
        QAction* action = addChoice(*menu, *group, words[i], curve.pattern() == pattern);
        action->setIcon(sample(theme.text, pattern));
        QObject::connect(action, &QAction::triggered, menu, [choose, pattern] { choose(pattern); });
    }
    return menu;
}

} // namespace halbench::widgets
