#include "widgets/parameters/parameter_table.h"

#include "widgets/controls/action_button.h"
#include "widgets/controls/copy_menu.h"
#include "widgets/controls/message_bar.h"
#include "widgets/language/phrasebook.h"
#include "widgets/parameters/parameter_delegate.h"
#include "widgets/parameters/parameter_filter_model.h"
#include "widgets/theme/icons.h"

#include <QAction>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>
#include <QTreeView>
#include <QVBoxLayout>

#include <utility>

namespace halbench::widgets {
namespace {

constexpr int HelpLines = 4;

void setWords(QAction& action, const QString& text, const QString& purpose) {
    const QString key = action.shortcut().toString(QKeySequence::NativeText);
    action.setText(text);
    action.setToolTip(key.isEmpty() ? purpose : QStringLiteral("%1 (%2)").arg(purpose, key));
}

} // namespace

ParameterTable::ParameterTable(QWidget* parent)
    : QWidget(parent), m_model(new ParameterTableModel(this)), m_filter(new ParameterFilterModel(this)),
      m_search(new QLineEdit(this)), m_changedOnly(new QPushButton(this)), m_angleUnit(new QComboBox(this)),
      m_view(new QTreeView(this)), m_messages(new MessageBar(this)), m_help(new QLabel(this)),
      m_writeButton(new QPushButton(this)) {
    m_filter->setSourceModel(m_model);
    createActions();
    createView();
    layOut();
    connectModel();
    retranslate();
}

ParameterTable::~ParameterTable() {
    // The undo stack and the view tell of their own end, when this is no longer a table.
    m_model->undoStack().disconnect(this);
    m_view->selectionModel()->disconnect(this);
    m_model->disconnect(this);
}

QAction* ParameterTable::addAction(const char* icon, const char* key) {
    auto* action = new QAction(themedIcon(QLatin1String(icon)), QString(), this);
    action->setShortcut(QKeySequence(QLatin1String(key)));
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    QWidget::addAction(action);
    return action;
}

void ParameterTable::createActions() {
    m_write = addAction("write", "Ctrl+Return");
    m_read = addAction("read", "F5");
    m_revert = addAction("revert", "Ctrl+Backspace");
    m_defaults = addAction("defaults", "");
    m_undo = addAction("undo", "Ctrl+Z");
    m_redo = addAction("redo", "Ctrl+Shift+Z");
    m_find = addAction("search", "Ctrl+F");
    connect(m_write, &QAction::triggered, this, &ParameterTable::write);
    connect(m_read, &QAction::triggered, this, [this] {
        m_model->acknowledgeOutsideChanges();
        Q_EMIT readRequested();
    });
    connect(m_revert, &QAction::triggered, m_model, &ParameterTableModel::revert);
    connect(m_defaults, &QAction::triggered, m_model, &ParameterTableModel::editToDefaults);
    connect(m_undo, &QAction::triggered, &m_model->undoStack(), &QUndoStack::undo);
    connect(m_redo, &QAction::triggered, &m_model->undoStack(), &QUndoStack::redo);
    connect(m_find, &QAction::triggered, this, [this] {
        m_search->setFocus(Qt::ShortcutFocusReason);
        m_search->selectAll();
    });
}

void ParameterTable::write() {
    // An open editor counts: it commits when it loses the focus. What it refuses stops the whole write.
    m_messages->clear();
    m_view->setFocus(Qt::ShortcutFocusReason);
    if (m_messages->isHidden() && m_model->changedCount() > 0) {
        Q_EMIT writeRequested(m_model->changedValues());
    }
}

void ParameterTable::createView() {
    m_view->setModel(m_filter);
    m_view->setItemDelegate(new ParameterDelegate(m_view));
    m_view->setAlternatingRowColors(false);
    m_view->setUniformRowHeights(true);
    m_view->setAllColumnsShowFocus(false);
    m_view->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                            QAbstractItemView::AnyKeyPressed | QAbstractItemView::SelectedClicked);
    m_view->setTabKeyNavigation(false);
    addCopyMenu(*m_view);
    m_view->setIndentation(PanelMargin_px);
    m_view->header()->setStretchLastSection(false);
    m_view->header()->setSectionsMovable(false);
    m_view->viewport()->installEventFilter(this);
    connect(m_view->header(), &QHeaderView::sectionResized, this,
            [this] { m_isWidthChosen = m_isWidthChosen || !m_isFitting; });
    m_search->setClearButtonEnabled(true);
    m_changedOnly->setCheckable(true);
    m_changedOnly->setIcon(themedIcon(QStringLiteral("filter")));
    m_changedOnly->setAutoDefault(false);
    m_help->setWordWrap(true);
    m_help->setTextFormat(Qt::PlainText);
    m_help->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_help->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_help->setMinimumHeight(HelpLines * fontMetrics().lineSpacing());
    setRole(*m_help, Role::Muted);
    setRole(*m_writeButton, Role::Primary);
    m_writeButton->setAutoDefault(false);
}

void ParameterTable::layOut() {
    auto* top = new QHBoxLayout;
    top->addWidget(m_search, 1);
    top->addWidget(m_changedOnly);
    top->addWidget(m_angleUnit);
    auto* bottom = new QHBoxLayout;
    for (QAction* action : {m_read, m_revert, m_defaults}) {
        bottom->addWidget(new ActionButton(*action, ActionButton::Shape::IconOnly, this));
    }
    bottom->addStretch(1);
    bottom->addWidget(new ActionButton(*m_undo, ActionButton::Shape::IconOnly, this));
    bottom->addWidget(new ActionButton(*m_redo, ActionButton::Shape::IconOnly, this));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(PanelMargin_px, PanelMargin_px, PanelMargin_px, PanelMargin_px);
    column->setSpacing(PanelMargin_px);
    column->addLayout(top);
    column->addWidget(m_view, 1);
    column->addWidget(m_messages); // takes its room from the rows, and moves none of them
    column->addWidget(m_help);
    column->addWidget(m_writeButton, 0, Qt::AlignLeft); // its own row: never squeezed by the others
    column->addLayout(bottom);
}

void ParameterTable::connectModel() {
    connect(m_search, &QLineEdit::textChanged, this, &ParameterTable::setSearch);
    connect(m_changedOnly, &QPushButton::toggled, this, [this](bool isOn) {
        m_filter->setChangedOnly(isOn);
        m_view->expandAll();
    });
    connect(m_angleUnit, QOverload<int>::of(&QComboBox::activated), this, &ParameterTable::onAngleUnitChosen);
    connect(m_writeButton, &QPushButton::clicked, m_write, &QAction::trigger);
    connect(m_model, &ParameterTableModel::dataChanged, this, [this] {
        if (!std::exchange(m_hasFittedColumns, true)) { // the first values are here: later ones move nothing
            QTimer::singleShot(0, this, &ParameterTable::fitColumns);
        }
    });
    connect(m_model, &ParameterTableModel::changedCountChanged, this, [this](int count) {
        refreshActions();
        Q_EMIT changedCountChanged(count);
    });
    connect(m_model, &ParameterTableModel::editRefused, this, &ParameterTable::onEditRefused);
    connect(m_messages, &MessageBar::actionTriggered, this, [this] {
        if (m_suggestion) {
            static_cast<void>(m_model->edit(m_refusedName, *m_suggestion)); // a refusal shows itself
        }
    });
    connect(&m_model->undoStack(), &QUndoStack::indexChanged, this, [this] {
        m_messages->clear(); // an edit that is taken answers the refusal; values that are read do not
        refreshActions();
    });
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this, &ParameterTable::showHelp);
}

void ParameterTable::setSpecs(std::vector<ParameterSpec> specs) {
    m_model->setSpecs(std::move(specs));
    m_view->expandAll();
    for (int row = 0; row < m_filter->rowCount(); ++row) {
        m_view->setFirstColumnSpanned(row, {}, true);
    }
    m_hasFittedColumns = false;
    fitColumns();
    showHelp();
}

void ParameterTable::setOnline(bool isOnline) {
    m_isOnline = isOnline;
    m_model->setStale(!isOnline);
    refreshActions();
}

void ParameterTable::setSearch(const QString& words) {
    m_search->setText(words);
    m_filter->setSearch(words);
    m_view->expandAll();
}

void ParameterTable::setAngleUnit(AngleUnit unit) {
    m_angleUnit->setCurrentIndex(unit == AngleUnit::Radian ? 0 : 1);
    onAngleUnitChosen(m_angleUnit->currentIndex());
}

void ParameterTable::onAngleUnitChosen(int index) {
    m_model->setAngleUnit(index == 0 ? AngleUnit::Radian : AngleUnit::Degree);
    showHelp();
    fitColumns();
}

void ParameterTable::onEditRefused(const QString& name, const QString& message, const QString& remedy,
                                   std::optional<double> suggestion) {
    m_refusedName = name.toStdString();
    m_suggestion = suggestion;
    const ParameterSpec* spec = m_model->specAt(m_model->indexOf(m_refusedName));
    const QString action = suggestion && spec != nullptr
                               ? tr("Use %1").arg(numberText(
                                     *suggestion * displayUnit(spec->unit, m_model->angleUnit()).factor, 7))
                               : QString();
    m_messages->showMessage({Severity::Error, message, remedy, action});
}

QString ParameterTable::helpText(const ParameterSpec& spec) const {
    const DisplayUnit unit = displayUnit(spec.unit, m_model->angleUnit());
    const auto shown = [&unit](double value) { return settingText(value * unit.factor); };
    QStringList facts = {tr("%1 to %2 %3, default %4")
                             .arg(shown(spec.min), shown(spec.max), unit.text, shown(spec.defaultValue))};
    if (spec.isTransactional) {
        facts << tr("changes together with the other gains in one control cycle");
    }
    if (spec.access == ParameterAccess::ReadOnly) {
        facts << tr("read-only");
    }
    return QStringLiteral("%1\n%2\n%3")
        .arg(QString::fromStdString(spec.name), inWords(spec.help), facts.join(QStringLiteral(" · ")));
}

void ParameterTable::showHelp() {
    const ParameterSpec* spec = m_model->specAt(m_filter->mapToSource(m_view->currentIndex()));
    m_help->setText(spec == nullptr ? tr("Select a parameter to see its description.") : helpText(*spec));
}

void ParameterTable::refreshActions() {
    const int count = m_model->changedCount();
    m_write->setEnabled(m_isOnline); // by key also for an editor that is still open
    m_read->setEnabled(m_isOnline);
    m_revert->setEnabled(count > 0);
    m_undo->setEnabled(m_model->undoStack().canUndo());
    m_redo->setEnabled(m_model->undoStack().canRedo());
    m_writeButton->setText(tr("Write changed (%1)").arg(count));
    m_writeButton->setEnabled(m_isOnline && count > 0);
    setWords(*m_write, tr("Write changed"), tr("Write the changed values to the device and read them back"));
    m_writeButton->setToolTip(m_isOnline ? m_write->toolTip() : tr("Connect a device to write to it"));
    m_writeButton->setAccessibleName(m_write->text());
    m_writeButton->setAccessibleDescription(m_writeButton->toolTip());
}

void ParameterTable::retranslate() {
    setWords(*m_read, tr("Read"), tr("Read all values from the device"));
    setWords(*m_revert, tr("Revert"), tr("Discard the edits and show the device values"));
    setWords(*m_defaults, tr("Defaults"), tr("Set every value to its default; nothing is written yet"));
    setWords(*m_undo, tr("Undo"), tr("Undo the last edit"));
    setWords(*m_redo, tr("Redo"), tr("Redo the edit"));
    setWords(*m_find, tr("Search"), tr("Search parameters"));
    m_search->setPlaceholderText(tr("Search name, unit or help"));
    m_search->setToolTip(m_find->toolTip());
    m_search->setAccessibleName(m_find->toolTip());
    m_changedOnly->setText(tr("Changed only"));
    m_changedOnly->setToolTip(tr("Show only values edited here or changed on the device"));
    m_changedOnly->setAccessibleName(tr("Changed only"));
    const int unit = m_angleUnit->currentIndex();
    m_angleUnit->clear();
    m_angleUnit->addItems({QStringLiteral("rad"), QStringLiteral("\u00b0")});
    m_angleUnit->setCurrentIndex(qMax(0, unit));
    m_angleUnit->setToolTip(tr("Angle unit for display and input"));
    m_angleUnit->setAccessibleName(tr("Angle unit"));
    m_view->setAccessibleName(tr("Parameters"));
    m_view->setToolTip(tr("F2 or typing edits the value"));
    m_help->setAccessibleName(tr("Help on the parameter"));
    refreshActions();
    showHelp();
}

void ParameterTable::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

} // namespace halbench::widgets
