#include "app/workspaces/monitor/derived_panel.h"

#include "app/workbench/display_quantity.h"
#include "app/workspaces/monitor/expression_edit.h"
#include "app/workspaces/parts/panel_parts.h"
#include "control/base/unit_text.h"
#include "widgets/controls/copy_menu.h"
#include "widgets/language/phrasebook.h"
#include "widgets/language/whole_numbers.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace halbench::app {

namespace {

enum Column { Name, Expression, Unit, State, Columns };

/// As they are written, and in words.
std::vector<std::pair<QString, QString>> functions() {
    return {{QStringLiteral("sin("), DerivedPanel::tr("sine of an angle in rad")},
            {QStringLiteral("cos("), DerivedPanel::tr("cosine of an angle in rad")},
            {QStringLiteral("atan2("), DerivedPanel::tr("angle of the point (x, y): atan2(y, x)")},
            {QStringLiteral("sqrt("), DerivedPanel::tr("square root")},
            {QStringLiteral("abs("), DerivedPanel::tr("absolute value")},
            {QStringLiteral("exp("), DerivedPanel::tr("exponential function")},
            {QStringLiteral("ln("), DerivedPanel::tr("natural logarithm")},
            {QStringLiteral("min("), DerivedPanel::tr("smaller of two values")},
            {QStringLiteral("max("), DerivedPanel::tr("larger of two values")},
            {QStringLiteral("pi"), DerivedPanel::tr("ratio of circumference to diameter")}};
}

QString unitWords(const std::string& symbol) {
    return QString::fromStdString(unitText(symbol));
}

} // namespace

DerivedPanel::DerivedPanel(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    QVBoxLayout* column = makePanelColumn(this);
    column->addWidget(buildFields());
    m_problem = makeNote(this);
    m_problem->setAccessibleName(tr("Error in the expression"));
    column->addWidget(m_problem);
    m_list = new QTableWidget(0, Columns, this);
    m_list->setHorizontalHeaderLabels({tr("Name"), tr("Expression"), tr("Unit"), tr("State")});
    m_list->setAccessibleName(tr("Derived signals"));
    m_list->setToolTip(tr("Enter copies a row into the fields above, Delete removes it"));
    m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_list->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_list->setSelectionMode(QAbstractItemView::SingleSelection);
    m_list->setTabKeyNavigation(false);
    m_list->verticalHeader()->hide();
    m_list->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_list->horizontalHeader()->setStretchLastSection(true);
    m_list->setItemDelegate(new widgets::WholeNumbers(m_list));
    widgets::addCopyMenu(*m_list);
    column->addWidget(m_list, 1);
    buildEmpty();
    column->addWidget(m_empty, 1);
    connect(m_list, &QTableWidget::cellActivated, this, [this](int row) { edit(row); });
    connect(m_list, &QTableWidget::itemSelectionChanged, this,
            [this] { m_remove->setEnabled(m_list->currentRow() >= 0); });
    connect(&m_bench, &Workbench::derivedSignalsChanged, this, &DerivedPanel::showList);
    connect(&m_bench, &Workbench::deviceChanged, this, [this] {
        takeWords();
        showList(); // what waited is computed now
    });
    takeWords();
    showList();
}

QWidget* DerivedPanel::buildFields() {
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(widgets::GridStep_px);
    m_name = new QLineEdit(this);
    m_expression = new ExpressionEdit(this);
    m_unit = new QLineEdit(this);
    addField(m_name, tr("Name"), tr("Name in the signal tree: letters, digits, dots, underscores"), 12, *row);
    addField(m_expression, tr("Expression"), tr("Signals in SI units, e.g. current.a^2 (Enter adds it)"), 30,
             *row);
    addField(m_unit, tr("Unit"),
             tr("Unit of the result, e.g. rad, rad/s, T, A, degC; empty: derived from the expression"), 8,
             *row);
    QPushButton* insert =
        makeButton({tr("Insert"), tr("Insert a signal or a function into the expression"), {}}, box);
    m_insert = new QMenu(insert);
    insert->setMenu(m_insert);
    connect(m_insert, &QMenu::aboutToShow, this, &DerivedPanel::fillInsertMenu);
    row->insertWidget(row->indexOf(m_expression) + 1, insert);
    m_keep = makeButton({tr("Add"), tr("Add the signal; computed from now on (Enter)"), {}}, box);
    m_remove = makeButton({tr("Remove"), tr("Remove the selected signal (Delete)"), {}}, box);
    m_remove->setEnabled(false);
    row->addWidget(m_keep);
    row->addWidget(m_remove);
    connect(m_keep, &QPushButton::clicked, this, &DerivedPanel::keep);
    connect(m_remove, &QPushButton::clicked, this, &DerivedPanel::remove);
    return box;
}

void DerivedPanel::addField(QLineEdit* field, const QString& title, const QString& toolTip, int characters,
                            QHBoxLayout& row) {
    auto* label = new QLabel(title, this);
    label->setBuddy(field);
    field->setAccessibleName(title);
    field->setToolTip(toolTip);
    field->setMinimumWidth(characters * field->fontMetrics().averageCharWidth());
    row.addWidget(label);
    row.addWidget(field, characters);
    connect(field, &QLineEdit::textChanged, this, &DerivedPanel::check);
    connect(field, &QLineEdit::returnPressed, this, &DerivedPanel::keep);
}

void DerivedPanel::buildEmpty() {
    m_empty = makeNote(this);
    m_empty->setText(tr("No derived signals yet. Example: name power, expression current.a^2 + current.b^2.\n"
                        "Type a part of a signal's name to choose it, or drag it here from the signals."));
}

/// Signals of the device with both their names, then the functions.
void DerivedPanel::takeWords() {
    std::vector<ExpressionWord> words;
    for (const SignalSpec& spec : m_bench.session().catalogue().signals) {
        words.push_back({QString::fromStdString(spec.name), signalWords(spec.name)});
    }
    for (const auto& [text, title] : functions()) {
        words.push_back({text, title});
    }
    m_expression->setWords(words);
}

void DerivedPanel::fillInsertMenu() {
    m_insert->clear();
    QMenu* list = m_insert->addMenu(tr("Signal"));
    const auto add = [this](QMenu& menu, const QString& text, const QString& title) {
        menu.addAction(QStringLiteral("%1\t%2").arg(title, text), this, [this, text] {
            m_expression->insert(text);
            m_expression->setFocus(Qt::OtherFocusReason);
        });
    };
    for (const SignalSpec& spec : m_bench.session().catalogue().signals) {
        add(*list, QString::fromStdString(spec.name), signalWords(spec.name));
    }
    list->setEnabled(!list->isEmpty());
    QMenu* calls = m_insert->addMenu(tr("Function"));
    for (const auto& [text, title] : functions()) {
        add(*calls, text, title);
    }
}

devices::DerivedSignal DerivedPanel::typed() const {
    return {m_name->text().trimmed().toStdString(), m_expression->text().trimmed().toStdString(),
            m_unit->text().trimmed().toStdString()};
}

/// While it is typed; nothing is said of what was not begun.
void DerivedPanel::check() {
    const devices::DerivedSignal derived = typed();
    const bool isBegun = !derived.name.empty() && !derived.expression.empty();
    const auto checked = m_bench.derive(derived);
    m_keep->setEnabled(isBegun && checked);
    m_unit->setPlaceholderText(isBegun && checked && derived.unit.empty() ? unitWords(checked->unit)
                                                                          : QString());
    m_problem->setText(isBegun && !checked ? widgets::inWords(checked.error().message) +
                                                 QStringLiteral("; ") + widgets::inWords(checked.error().hint)
                                           : QString());
    showRole(*m_problem, widgets::Role::Warn);
}

void DerivedPanel::keep() {
    check();
    if (!m_keep->isEnabled()) {
        return;
    }
    const devices::DerivedSignal derived = typed();
    std::vector<devices::DerivedSignal> list = m_bench.derivedSignals();
    const auto same = std::find_if(list.begin(), list.end(), [&](const devices::DerivedSignal& one) {
        return one.name == derived.name;
    });
    const bool isNew = same == list.end();
    if (isNew) {
        list.push_back(derived);
    } else {
        *same = derived;
    }
    m_bench.setDerivedSignals(std::move(list));
    if (isNew) {
        Q_EMIT plotRequested(QString::fromStdString(derived.name), true);
    }
    for (QLineEdit* field : std::initializer_list<QLineEdit*>{m_name, m_expression, m_unit}) {
        field->clear();
    }
    m_name->setFocus();
}

void DerivedPanel::remove() {
    std::vector<devices::DerivedSignal> list = m_bench.derivedSignals();
    const int row = m_list->currentRow();
    if (row >= 0 && row < static_cast<int>(list.size())) {
        list.erase(list.begin() + row);
        m_bench.setDerivedSignals(std::move(list));
    }
}

void DerivedPanel::edit(int row) {
    const devices::DerivedSignal& derived = m_bench.derivedSignals().at(static_cast<std::size_t>(row));
    m_name->setText(QString::fromStdString(derived.name));
    m_expression->setText(QString::fromStdString(derived.expression));
    m_unit->setText(QString::fromStdString(derived.unit));
    m_expression->setFocus();
}

void DerivedPanel::showList() {
    const std::vector<devices::DerivedSignal>& list = m_bench.derivedSignals();
    m_list->setVisible(!list.empty());
    m_empty->setVisible(list.empty());
    m_list->setRowCount(static_cast<int>(list.size()));
    for (int row = 0; row < m_list->rowCount(); ++row) {
        const devices::DerivedSignal& derived = list[static_cast<std::size_t>(row)];
        const bool isConnected = !m_bench.session().catalogue().signals.empty();
        const auto checked = m_bench.derive(derived);
        const QString state = !isConnected ? tr("waits for a device")
                              : checked    ? tr("computed")
                                           : widgets::inWords(checked.error().message);
        int column = 0;
        for (const QString& text :
             {QString::fromStdString(derived.name), QString::fromStdString(derived.expression),
              checked ? unitWords(checked->unit) : unitWords(derived.unit), state}) {
            m_list->setItem(row, column++, new QTableWidgetItem(text));
        }
    }
    check();
}

void DerivedPanel::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Delete && m_list->hasFocus()) {
        remove();
        return;
    }
    QWidget::keyPressEvent(event);
}

} // namespace halbench::app
