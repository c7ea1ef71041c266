#pragma once

#include "app/recordings/recording_list.h"

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>

namespace halbench::app {

/// The recordings of a folder as rows.
class RecordingsTableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, Date, Length, Device, Signals, Gaps, Tags, Results, ColumnCount };
    static constexpr int SortRole = Qt::UserRole;       ///< what a column is ordered by
    static constexpr int SearchRole = Qt::UserRole + 1; ///< all words of the row

    using QAbstractTableModel::QAbstractTableModel;

    void setEntries(std::vector<RecordingEntry> entries);
    /// What the user wrote about one of them.
    void setWords(const QString& path, const QStringList& tags, const QString& notes);
    const RecordingEntry& entry(int row) const { return m_entries[static_cast<std::size_t>(row)]; }
    /// -1: there is none.
    int rowOf(const QString& path) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<RecordingEntry> m_entries;
};

/// Rows in which every word that is searched for occurs somewhere.
class RecordingsFilterModel : public QSortFilterProxyModel {
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;
    void setWords(const QString& words);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    QStringList m_words;
};

} // namespace halbench::app
