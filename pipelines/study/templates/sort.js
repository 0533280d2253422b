// Sorts a table by the column whose head is pressed: numbers by value, words by alphabet; pressed again, the other way.
document.querySelectorAll("table.sortable th").forEach(function (head) {
  head.tabIndex = 0;
  function sort() {
    var body = head.closest("table").tBodies[0], column = head.cellIndex;
    var sign = head.getAttribute("aria-sort") === "ascending" ? -1 : 1;
    function key(row) { return row.cells[column].textContent.replace("\u2212", "-").replace(/^at (most|least) /, "").trim(); }
    var rows = Array.from(body.rows).sort(function (a, b) {
      var x = parseFloat(key(a)), y = parseFloat(key(b));
      return sign * (isNaN(x) || isNaN(y) ? key(a).localeCompare(key(b)) : x - y);
    });
    head.parentNode.querySelectorAll("th").forEach(function (other) { other.removeAttribute("aria-sort"); });
    head.setAttribute("aria-sort", sign === 1 ? "ascending" : "descending");
    rows.forEach(function (row) { body.appendChild(row); });
  }
  head.addEventListener("click", sort);
  head.addEventListener("keydown", function (event) { if (event.key === "Enter") { sort(); } });
});
