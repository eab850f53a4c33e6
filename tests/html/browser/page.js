// What is asked of a page from within, each as a list of complaints.

const shortly = (node) => {
  const element = node.nodeType === 1 ? node : node.parentElement;
  const place = element.closest("[id]");
  return "<" + element.localName + (element.getAttribute("class") ? "." + element.getAttribute("class") : "") + "> in #" +
    (place ? place.id : "") + ": " + node.textContent.trim().slice(0, 40);
};

// One complaint of a kind is enough to find the others.
const few = (complaints) => [...new Set(complaints)].slice(0, 12);

// Answers that are kept, for the many texts of a page stand in the same few elements.
const kept = (question) => {
  const known = new Map();
  return (element) => {
    if (!known.has(element)) { known.set(element, question(element)); }
    return known.get(element);
  };
};

const visible = (element) => element.checkVisibility({ visibilityProperty: true, contentVisibilityAuto: true });

const texts = () => {
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const found = [];
  while (walker.nextNode()) {
    const node = walker.currentNode;
    const hidden = node.parentElement.closest("script, style, title, desc");
    if (!hidden && node.data.trim() !== "" && visible(node.parentElement)) { found.push(node); }
  }
  return found;
};

const unfold = () => document.querySelectorAll("details").forEach((details) => { details.open = true; });

// Formulas are set: each takes up room, scripts and fractions stand where they belong, and no source is left to be seen.
const mathematics = () => {
  const complaints = [];
  const box = (element) => element.getBoundingClientRect();
  const all = [...document.querySelectorAll("math")].filter(visible);
  for (const math of all) {
    if (box(math).width < 3 || box(math).height < 3) { complaints.push("no room: " + shortly(math)); }
    for (const part of math.querySelectorAll("mi, mn, mtext")) {
      if (box(part).width === 0) { complaints.push("a part without room: " + shortly(part)); }
    }
  }
  const inside = (name) => all.flatMap((math) => [...math.querySelectorAll(name)]);
  for (const fraction of inside("mfrac")) {
    const [over, under] = fraction.children;
    if (box(over).bottom > box(under).top + 1) { complaints.push("a fraction in a line: " + shortly(fraction)); }
  }
  for (const [name, side] of [["msup", -1], ["msub", 1]]) {
    for (const element of inside(name)) {
      const [base, script] = element.children;
      const middle = (part) => (box(part).top + box(part).bottom) / 2;
      if ((middle(script) - middle(base)) * side <= 0) { complaints.push("a script in the line: " + shortly(element)); }
    }
  }
  for (const node of texts()) {
    if (node.parentElement.closest("code, pre")) { continue; }
    if (/\\[a-zA-Z]|\$|[_^][{(]/.test(node.data)) { complaints.push("source: " + shortly(node)); }
  }
  return { count: all.length, fractions: inside("mfrac").length, complaints: few(complaints) };
};

const links = () => few([...document.querySelectorAll("a")].flatMap((link) => {
  const target = link.getAttribute("href");
  if (!target) { return ["leads nowhere: " + shortly(link)]; }
  if (!target.startsWith("#")) { return []; }
  const found = document.getElementById(decodeURIComponent(target.slice(1)));
  return found ? [] : [target + " is nowhere: " + shortly(link)];
}));

// Whether the top of what an address points to is on the screen.
const arrived = () => {
  const target = document.querySelector(":target");
  if (!target) { return "nothing is meant by " + location.hash; }
  const box = target.getBoundingClientRect();
  return box.top > -2 && box.top < innerHeight ? "" : "#" + target.id + " is at " + box.top;
};

// Contrast as WCAG 2 has it: 4.5, or 3 for large text.
const channel = (part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4);
const luminance = ([red, green, blue]) => 0.2126 * channel(red / 255) + 0.7152 * channel(green / 255) + 0.0722 * channel(blue / 255);
const parsed = (colour) => {
  const found = colour.match(/^rgba?\(([\d.]+), ([\d.]+), ([\d.]+)(?:, ([\d.]+))?\)$/);
  return found ? found.slice(1).map((part) => (part === undefined ? 1 : Number(part))) : null;
};
const ratio = (one, other) => {
  const [low, high] = [luminance(one), luminance(other)].sort((a, b) => a - b);
  return (high + 0.05) / (low + 0.05);
};

// The ground that text of a page stands on: the nearest that is not transparent.
const ground = kept((element) => {
  if (!element) { return [255, 255, 255, 1]; }
  const colour = parsed(getComputedStyle(element).backgroundColor);
  if (colour && colour[3] !== 0) { return colour[3] === 1 ? colour : null; }
  return ground(element.parentElement);
});

const opacity = kept((element) =>
  element ? Number(getComputedStyle(element).opacity) * opacity(element.parentElement) : 1);

// The ground of text in a drawing: the last shape before it that is filled and lies under its middle.
const painted = (svg) => [...svg.querySelectorAll("rect, path")].flatMap((shape) => {
  const fill = parsed(getComputedStyle(shape).fill);
  return fill && fill[3] === 1 ? [{ shape, fill, box: shape.getBoundingClientRect() }] : [];
});

const contrast = () => {
  const complaints = [];
  const drawings = new Map();
  let least = 21;
  const nodes = texts();
  for (const node of nodes) {
    const element = node.parentElement;
    const style = getComputedStyle(element);
    const svg = element.closest("svg");
    let colour = parsed(svg ? style.fill : style.color);
    let under = null;
    if (svg) {
      if (!drawings.has(svg)) { drawings.set(svg, painted(svg)); }
      const box = element.closest("text").getBoundingClientRect();
      const [x, y] = [(box.left + box.right) / 2, (box.top + box.bottom) / 2];
      for (const { shape, fill, box } of drawings.get(svg)) {
        const before = shape.compareDocumentPosition(element) & Node.DOCUMENT_POSITION_FOLLOWING;
        if (before && box.left <= x && x <= box.right && box.top <= y && y <= box.bottom) { under = fill; }
      }
    } else {
      under = ground(element);
    }
    if (!colour || !under || colour[3] !== 1 || opacity(element) !== 1) {
      complaints.push("no plain colour: " + style.color + " " + shortly(node));
      continue;
    }
    const size = parseFloat(style.fontSize);
    const large = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
    const own = ratio(colour, under);
    least = Math.min(least, own);
    if (own < (large ? 3 : 4.5)) { complaints.push(own.toFixed(2) + ": " + shortly(node)); }
  }
  const paper = ground(document.body);
  return { count: nodes.length, least, paper: paper.join(" "), complaints: few(complaints) };
};

// Whether an element scrolls or lies in one that does.
const within = kept((element) => {
  if (!element || element === document.body) { return false; }
  return /auto|scroll/.test(getComputedStyle(element).overflowX) || within(element.parentElement);
});

// Nothing is wider than the window, but what scrolls in a box of its own; and nothing is cut off.
const width = () => {
  const root = document.documentElement;
  const complaints = [];
  if (root.scrollWidth > root.clientWidth) { complaints.push(root.scrollWidth + " in " + root.clientWidth); }
  for (const element of document.body.querySelectorAll("*")) {
    if (!visible(element) || element.closest("svg, math") !== null && !element.matches("svg, math")) { continue; }
    if (element.matches(".skip")) { continue; }
    const box = element.getBoundingClientRect();
    if (!within(element.parentElement) && box.width > 0 && (box.right > root.clientWidth + 1 || box.left < -1)) {
      complaints.push("from " + Math.round(box.left) + " to " + Math.round(box.right) + ": " + shortly(element));
    }
    const own = getComputedStyle(element).overflowX;
    if ((own === "hidden" || own === "clip") && element.scrollWidth > element.clientWidth + 1) {
      complaints.push("cut off: " + shortly(element));
    }
  }
  return few(complaints);
};
