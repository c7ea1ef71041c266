#include "widgets/theme/theme_sheet.h"

#include "widgets/theme/theme_style.h"

#include <QPair>
#include <QVector>

namespace halbench::widgets {
namespace {

// @name@ is a token of the theme; borders give way to the focus ring inside, so that nothing moves.
constexpr const char* Controls = R"(
QToolTip { background: @raised@; color: @text@; border: 1px solid @line@; padding: 4px; }
QPushButton, QToolButton { background: @raised@; color: @text@; border: 1px solid @line@; border-radius: 4px;
    padding: 1px 9px; min-height: @inner@px; outline: none; }
QToolButton { padding: 1px 5px; }
QToolButton[autoRaise="true"] { background: transparent; border-color: transparent; }
QPushButton:hover, QToolButton:hover { border-color: @muted@; background: @hover@; }
QPushButton:pressed, QToolButton:pressed, QPushButton:checked, QToolButton:checked
    { background: @line@; border-color: @muted@; }
QPushButton:disabled, QToolButton:disabled { color: @disabled@; background: @window@; }
QToolButton[autoRaise="true"]:disabled { background: transparent; }
QPushButton:focus, QToolButton:focus { border: 2px solid @accent@; padding: 0px 8px; }
QToolButton:focus { padding: 0px 4px; }
QToolButton::menu-indicator { image: none; width: 0px; }
QPushButton[role="primary"] { background: @accent@; color: @onaccent@; border-color: @accent@; }
QPushButton[role="primary"]:hover { background: @accenthover@; }
QPushButton[role="primary"]:disabled { background: @raised@; color: @disabled@; border-color: @line@; }
QPushButton[role="primary"]:focus { border: 2px solid @text@; }
QPushButton[role="armed"] { background: @armed@; color: @onarmed@; border-color: @armed@; }
QPushButton[role="armed"]:focus { border: 2px solid @text@; }
QPushButton[role="stop"] { background: @stop@; color: @stoptext@; border: 2px solid @stop@; font-weight: bold;
    padding: 0px 8px; }
QPushButton[role="stop"]:hover { background: @stophover@; }
QPushButton[role="stop"]:pressed { background: @stoppressed@; }
QPushButton[role="stop"]:focus { border: 2px solid @text@; }
QLineEdit, QPlainTextEdit, QTextEdit, QTextBrowser { background: @panel@; border: 1px solid @line@;
    border-radius: 4px; padding: 1px 5px; selection-background-color: @accent@; selection-color: @onaccent@; }
QLineEdit { min-height: @inner@px; }
QLineEdit:hover { border-color: @muted@; }
QLineEdit:focus, QPlainTextEdit:focus, QTextEdit:focus, QTextBrowser:focus { border: 2px solid @accent@;
    padding: 0px 4px; }
QLineEdit:disabled { background: @window@; }
QLineEdit[role="bad"] { border: 2px solid @bad@; padding: 0px 4px; }
QAbstractSpinBox { min-height: @control@px; }
QAbstractSpinBox > QLineEdit, QComboBox > QLineEdit, QAbstractItemView QLineEdit { border: none; padding: 0px;
    min-height: 0px; background: @panel@; }
QAbstractItemView QLineEdit { border: 2px solid @accent@; border-radius: 0px; padding: 0px 2px; }
)";

// `!important` where the docking library has a sheet of its own for its tabs.
constexpr const char* Surfaces = R"(
QAbstractItemView { background: @panel@; alternate-background-color: @alternate@; border: 1px solid @line@;
    gridline-color: @line@; selection-background-color: @selection@; selection-color: @text@; outline: 0; }
QAbstractItemView:focus { border: 1px solid @accent@; }
QAbstractItemView[surface="legend"] { background: transparent; border: 1px solid transparent; }
QAbstractItemView[surface="legend"]:focus { border: 1px solid @accent@; }
QAbstractItemView[surface="steps"] { background: transparent; border: none; }
QTreeView::item, QListView::item, QTableView::item { padding: 0px; min-height: @row@px; }
QTreeView::item:selected, QListView::item:selected, QTableView::item:selected { background: @selection@;
    color: @text@; }
QTreeView::item:focus, QListView::item:focus, QTableView::item:focus { border: 2px solid @accent@; }
QHeaderView { background: @raised@; border: none; }
QTableCornerButton::section { background: @raised@; border: none; border-bottom: 1px solid @line@; }
QHeaderView::section { background: @raised@; color: @muted@; border: none; border-right: 1px solid @line@;
    border-bottom: 1px solid @line@; padding: 4px; }
QTabBar::tab { background: transparent; color: @muted@; border: none; border-bottom: 2px solid transparent;
    padding: 5px 12px; }
QTabBar::tab:selected { color: @text@; border-bottom: 2px solid @accent@; }
QTabBar::tab:hover { color: @text@; }
QTabBar::tab:selected:focus { background: @selection@; }
QTabWidget::pane { border: none; border-top: 1px solid @line@; }
QMenuBar { background: @window@; }
QMenuBar::item { background: transparent; padding: 4px 8px; }
QMenuBar::item:selected { background: @selection@; }
QMenu { background: @panel@; color: @text@; border: 1px solid @line@; padding: 4px 0px; }
QMenu::item { padding: 5px 24px 5px 28px; }
QMenu::item:selected { background: @selection@; }
QMenu::item:disabled { color: @disabled@; }
QMenu::separator { height: 1px; background: @line@; margin: 4px 0px; }
QMenu::icon { padding-left: 8px; }
QProgressBar { background: @raised@; border: 1px solid @line@; border-radius: 4px; text-align: center;
    color: @text@; min-height: 8px; max-height: 8px; }
QProgressBar::chunk { background: @accent@; border-radius: 3px; }
QSlider::groove:horizontal { background: @line@; height: 4px; border-radius: 2px; }
QSlider::sub-page:horizontal { background: @accent@; border-radius: 2px; }
QSlider::sub-page:horizontal:disabled { background: @line@; }
QSlider::handle:horizontal { background: @accent@; border: 2px solid @panel@; width: 12px; margin: -6px 0px;
    border-radius: 8px; }
QSlider::handle:horizontal:hover { background: @accenthover@; }
QSlider::handle:horizontal:disabled { background: @disabled@; }
QSlider:focus { border: 2px solid @accent@; border-radius: 4px; }
QSlider { border: 2px solid transparent; min-height: @inner@px; }
QGroupBox { border: none; margin-top: @inner@px; padding-top: 4px; }
QGroupBox::title { subcontrol-origin: margin; left: 0px; color: @muted@; }
QSplitter::handle { background: @line@; }
QSplitter[surface="plots"]::handle { background: @raised@; }
QSplitter::handle:horizontal { width: 1px; } QSplitter::handle:vertical { height: 1px; }
QToolBar { background: @window@; border: none; border-bottom: 1px solid @line@; spacing: 4px; padding: 2px 8px; }
#qt_toolbar_ext_button { background: transparent; border: 1px solid @line@; padding: 0px; min-height: 0px; }
QToolBar::separator { background: @line@; width: 1px; margin: 4px; }
ads--CDockWidgetTab { background: @window@ !important; border: none !important;
    border-bottom: 2px solid @window@ !important; padding: 2px 0px; }
ads--CDockWidgetTab[activeTab="true"] { border-bottom: 2px solid @accent@ !important; }
ads--CDockWidgetTab QLabel { color: @muted@ !important; }
ads--CDockWidgetTab[activeTab="true"] QLabel { color: @text@ !important; }
QStatusBar { background: @window@; border-top: 1px solid @line@; } QStatusBar::item { border: none; }
QScrollBar { background: transparent; border: none; margin: 0px; }
QScrollBar:vertical { width: 12px; } QScrollBar:horizontal { height: 12px; }
QScrollBar::handle { background: @handle@; border-radius: 4px; margin: 2px; }
QScrollBar::handle:hover { background: @muted@; }
QScrollBar::handle:vertical { min-height: 24px; } QScrollBar::handle:horizontal { min-width: 24px; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0px; height: 0px; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
)";

constexpr const char* Roles = R"(
QLabel[role="muted"] { color: @muted@; } QLabel[role="good"] { color: @good@; }
QLabel[role="warn"] { color: @warn@; } QLabel[role="bad"] { color: @bad@; }
QLabel[role="armed"] { color: @armed@; } QLabel[role="simulated"] { color: @simulated@; }
QLabel[role="primary"] { color: @accent@; } QLabel[heading="true"] { font-weight: bold; }
QLabel[badge="true"] { border-radius: 4px; padding: 3px 8px; font-weight: bold; border: 1px solid @muted@;
    color: @muted@; }
QLabel[badge="true"][role="simulated"] { background: @simulated@; color: @onsimulated@; border-color: @simulated@; }
QLabel[badge="true"][role="primary"] { background: @accent@; color: @onaccent@; border-color: @accent@; }
QLabel[badge="true"][role="armed"] { background: @armed@; color: @onarmed@; border-color: @armed@; }
QLabel[badge="true"][role="good"] { color: @good@; border-color: @good@; }
QLabel[badge="true"][role="bad"] { color: @bad@; border: 2px solid @bad@; padding: 2px 7px; }
QFrame[surface="panel"] { background: @panel@; border: 1px solid @line@; border-radius: 4px; }
QFrame[surface="strip"] { background: @window@; border: none; border-bottom: 1px solid @line@; }
QFrame[surface="strip"][role="armed"] { border-bottom: 3px solid @armed@; }
QFrame[surface="strip"][role="bad"] { border-bottom: 3px solid @bad@; }
QFrame[surface="strip"][role="good"] { border-bottom: 3px solid @good@; }
QFrame[surface="message"] { background: @panel@; border: 1px solid @line@; border-left: 4px solid @muted@;
    border-radius: 0px; }
QFrame[surface="message"][role="bad"] { border-left-color: @bad@; }
QFrame[surface="message"][role="warn"] { border-left-color: @warn@; }
QFrame[surface="message"][role="good"] { border-left-color: @good@; }
QFrame[surface="message"][role="primary"] { border-left-color: @accent@; }
)";

} // namespace

QString styleSheetOf(const Theme& theme, int fontHeight_px) {
    const QVector<QPair<QString, QColor>> colours = {
        {QStringLiteral("window"), theme.window},
        {QStringLiteral("panel"), theme.panel},
        {QStringLiteral("raised"), theme.raised},
        {QStringLiteral("text"), theme.text},
        {QStringLiteral("muted"), theme.muted},
        {QStringLiteral("disabled"), theme.disabled},
        {QStringLiteral("line"), theme.line},
        {QStringLiteral("accent"), theme.accent},
        {QStringLiteral("good"), theme.good},
        {QStringLiteral("warn"), theme.warn},
        {QStringLiteral("bad"), theme.bad},
        {QStringLiteral("simulated"), theme.simulated},
        {QStringLiteral("armed"), theme.armed},
        {QStringLiteral("stop"), theme.stop},
        {QStringLiteral("stoptext"), theme.stopText},
        {QStringLiteral("onaccent"), readableOn(theme, theme.accent)},
        {QStringLiteral("onarmed"), readableOn(theme, theme.armed)},
        {QStringLiteral("onsimulated"), readableOn(theme, theme.simulated)},
        {QStringLiteral("hover"), mixed(theme.raised, theme.line, 0.5)},
        {QStringLiteral("handle"), mixed(theme.line, theme.muted, 0.4)},
        {QStringLiteral("alternate"), mixed(theme.panel, theme.raised, 0.5)},
        {QStringLiteral("selection"), mixed(theme.panel, theme.accent, 0.22)},
        {QStringLiteral("accenthover"), mixed(theme.accent, theme.text, 0.12)},
        {QStringLiteral("stophover"), mixed(theme.stop, theme.window, 0.08)},
        {QStringLiteral("stoppressed"), mixed(theme.stop, theme.text, 0.2)},
    };
    QString sheet =
        QString::fromLatin1(Controls) + QString::fromLatin1(Surfaces) + QString::fromLatin1(Roles);
    for (const auto& [name, colour] : colours) {
        sheet.replace(QStringLiteral("@%1@").arg(name), colour.name());
    }
    // Controls are 28 px and rows 26 px high with the font's 17 px; borders and padding take 4 px, the frame
    // of a spin box 6.
    sheet.replace(QStringLiteral("@inner@"), QString::number(fontHeight_px + 7));
    sheet.replace(QStringLiteral("@control@"), QString::number(fontHeight_px + 5));
    sheet.replace(QStringLiteral("@row@"), QString::number(fontHeight_px + 9));
    return sheet;
}

} // namespace halbench::widgets
