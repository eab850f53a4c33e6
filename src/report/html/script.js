// Filters by verdict, and unfolds all evidence; the page is whole without it.
(function () {
  "use strict";
  var place = document.getElementById("filter");
  var equations = Array.from(document.querySelectorAll(".equation"));
  if (!place || equations.length === 0) { return; }
  place.className = "filter";
  place.setAttribute("role", "group");
  place.setAttribute("aria-label", "Show equations by verdict");
  var parts = Array.from(document.querySelectorAll("article > *"));
  var has = function (equation, word) { return equation.dataset.verdict.split(" ").includes(word); };
  var show = function (word) {
    equations.forEach(function (equation) { equation.hidden = word !== "" ? !has(equation, word) : false; });
    parts.forEach(function (part) {
      var own = part.matches(".equation") ? [part] : Array.from(part.querySelectorAll(".equation"));
      var kept = own.some(function (equation) { return !equation.hidden; });
      part.hidden = word === "" || part.matches("h3") ? false : !kept;
    });
  };
  var buttons = [];
  var add = function (text, press) {
    var button = document.createElement("button");
    button.type = "button";
    button.textContent = text;
    button.addEventListener("click", function () { press(button); });
    place.appendChild(button);
    return button;
  };
  ["", "given", "holds", "fails", "ill-dimensioned", "undecided"].forEach(function (word) {
    if (equations.every(function (equation) { return word !== "" ? !has(equation, word) : false; })) { return; }
    var button = add(word || "all", function (pressed) {
      show(word);
      buttons.forEach(function (other) { other.setAttribute("aria-pressed", String(other === pressed)); });
    });
    button.setAttribute("aria-pressed", String(word === ""));
    buttons.push(button);
  });
  var fold = add("unfold all evidence", function () {
    var open = fold.textContent.startsWith("unfold");
    document.querySelectorAll("details").forEach(function (details) { details.open = open; });
    fold.textContent = (open ? "fold" : "unfold") + " all evidence";
  });
  // A link to an equation that is filtered out shows it again.
  window.addEventListener("hashchange", function () {
    var target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    var equation = target ? target.closest(".equation") : null;
    if (equation ? equation.hidden : false) {
      buttons[0].click();
      target.scrollIntoView();
    }
  });
}());
