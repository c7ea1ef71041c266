#include "app/workspaces/device/simulation_options_dialog.h"

#include "widgets/controls/message_bar.h"
#include "widgets/language/phrasebook.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace halbench::app {
namespace {

using Row = devices::SimulationOptions::Row;

constexpr int Width_em = 58;
constexpr int Height_em = 32;

QString text(const std::string& words) {
    return QString::fromStdString(words);
}

QString number(double value) {
    return text(fmt::format("{:g}", value));
}

QString rangeText(const devices::OverrideSpec& spec) {
    if (spec.isText) {
        return {};
    }
    QStringList choices;
    for (const std::string& choice : spec.choices) {
        choices << text(choice);
    }
    return choices.isEmpty() ? SimulationOptionsDialog::tr("%1 to %2").arg(number(spec.min), number(spec.max))
                             : choices.join(QStringLiteral(", "));
}

QString standardText(const devices::OverrideSpec& spec) {
    if (!spec.choices.empty()) {
        return text(spec.choices.at(static_cast<std::size_t>(spec.standard.value_or(0.0))));
    }
    if (spec.isText) {
        return {};
    }
    return spec.standard ? number(*spec.standard) : SimulationOptionsDialog::tr("random");
}

QString meaningText(const devices::OverrideSpec& spec) {
    QString words = widgets::inWords(spec.meaning);
    return words.isEmpty() ? words : words.at(0).toUpper() + words.mid(1);
}

} // namespace

SimulationOptionsDialog::SimulationOptionsDialog(devices::SimulationOptions options, QWidget* parent)
    : QDialog(parent), m_options(std::move(options)) {
    setWindowTitle(tr("Simulation options"));
    m_filter = new QLineEdit(this);
    m_filter->setAccessibleName(tr("Filter"));
    m_filter->setPlaceholderText(tr("Filter by name or meaning"));
    m_filter->setClearButtonEnabled(true);
    m_message = new widgets::MessageBar(this);
    buildTable();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_use = buttons->button(QDialogButtonBox::Ok);
    m_use->setToolTip(tr("Write the options into the address"));
    QPushButton* clear = buttons->addButton(tr("Standard values"), QDialogButtonBox::ResetRole);
    clear->setToolTip(tr("Remove all options"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(clear, &QPushButton::clicked, this, &SimulationOptionsDialog::clearAll);
    connect(m_filter, &QLineEdit::textChanged, this, &SimulationOptionsDialog::filterRows);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_filter);
    column->addWidget(m_table, 1);
    column->addWidget(m_message);
    column->addWidget(buttons);
    const int em_px = fontMetrics().height();
    resize(Width_em * em_px, Height_em * em_px);
    refresh();
}

void SimulationOptionsDialog::buildTable() {
    m_table = new QTableWidget(static_cast<int>(m_options.rows().size()), ColumnCount, this);
    m_table->setAccessibleName(tr("Simulation options"));
    m_table->setHorizontalHeaderLabels(
        {tr("Key"), tr("Value"), tr("Unit"), tr("Standard"), tr("Range"), tr("Meaning")});
    m_table->verticalHeader()->hide();
    m_table->setTabKeyNavigation(false);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    for (int row = 0; row < m_table->rowCount(); ++row) {
        fillRow(row, m_options.rows()[static_cast<std::size_t>(row)]);
    }
    m_table->resizeColumnsToContents();
    m_table->horizontalHeader()->setSectionResizeMode(Meaning, QHeaderView::Stretch);
    m_table->setColumnWidth(Value, std::max(m_table->columnWidth(Value), 6 * fontMetrics().height()));
    m_table->setCurrentCell(0, Value);
    connect(m_table, &QTableWidget::itemChanged, this, &SimulationOptionsDialog::onEdited);
}

void SimulationOptionsDialog::fillRow(int row, const Row& option) {
    const auto& spec = option.spec;
    const QString cells[ColumnCount] = {text(spec.key),     text(option.value), text(spec.unit),
                                        standardText(spec), rangeText(spec),    meaningText(spec)};
    for (int column = 0; column < ColumnCount; ++column) {
        auto* item = new QTableWidgetItem(cells[column]);
        const bool isEdited = column == Value && spec.choices.empty();
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable |
                       (isEdited ? Qt::ItemIsEditable : Qt::NoItemFlags));
        item->setToolTip(column == Meaning ? cells[column] : QString());
        m_table->setItem(row, column, item);
    }
    if (!spec.choices.empty()) {
        addChoices(row, option);
    }
}

void SimulationOptionsDialog::addChoices(int row, const Row& option) {
    auto* box = new QComboBox(m_table);
    box->setAccessibleName(text(option.spec.key));
    box->addItem(QString());
    for (const std::string& choice : option.spec.choices) {
        box->addItem(text(choice));
    }
    if (box->findText(text(option.value)) < 0) {
        box->addItem(text(option.value)); // the index of a word, as an address may have it
    }
    box->setCurrentText(text(option.value));
    connect(box, &QComboBox::currentTextChanged, this, [this, row](const QString& value) {
        setOption(row, value);
        refresh();
    });
    m_table->setCellWidget(row, Value, box);
}

void SimulationOptionsDialog::setOption(int row, const QString& value) {
    m_options.set(static_cast<std::size_t>(row), value.trimmed().toStdString());
}

void SimulationOptionsDialog::onEdited(QTableWidgetItem* item) {
    if (item->column() == Value) {
        setOption(item->row(), item->text());
        refresh();
    }
}

void SimulationOptionsDialog::clearAll() {
    m_options.clear();
    const QSignalBlocker quiet(m_table);
    for (int row = 0; row < m_table->rowCount(); ++row) {
        m_table->item(row, Value)->setText(QString());
        if (auto* box = qobject_cast<QComboBox*>(m_table->cellWidget(row, Value))) {
            box->setCurrentIndex(0);
        }
    }
    refresh();
}

void SimulationOptionsDialog::filterRows(const QString& words) {
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const bool isFound = m_table->item(row, Key)->text().contains(words, Qt::CaseInsensitive) ||
                             m_table->item(row, Meaning)->text().contains(words, Qt::CaseInsensitive);
        m_table->setRowHidden(row, !isFound);
    }
}

/// The hint of the check lists every key; here the table does.
void SimulationOptionsDialog::refresh() {
    const Result<void> checked = m_options.check();
    m_use->setEnabled(checked.has_value());
    if (checked) {
        m_message->clear();
    } else {
        m_message->showMessage({widgets::Severity::Error,
                                widgets::inWords(checked.error().message),
                                tr("Enter a value of the range, or leave the cell empty."),
                                {}});
    }
}

QString SimulationOptionsDialog::address() const {
    return text(m_options.address());
}

} // namespace halbench::app
