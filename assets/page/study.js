// The page can be read without this. With it dots explain themselves, families and axes switch, rows sort, filter and compare.
"use strict";
(() => {
  const all = (selector, within = document) => [...within.querySelectorAll(selector)];
  const one = (selector) => document.querySelector(selector);
  document.documentElement.classList.add("script");

  const details = JSON.parse(one("#details").textContent);
  const rows = all("#rows tbody tr");
  const rowOf = new Map(rows.map((row) => [row.dataset.row, row]));
  const dots = all("figure .drawing > svg .dot");
  const dotsOf = new Map();
  for (const dot of dots) {
    const title = dot.querySelector("title");  // else the browser shows its own words as well
    dot.words = title.textContent;
    dot.setAttribute("aria-label", dot.words);
    title.remove();
    if (dot.dataset.row) dotsOf.set(dot.dataset.row, [...(dotsOf.get(dot.dataset.row) || []), dot]);
  }
  const wordsOf = (row) => row.querySelector("th").textContent;
  const picturesOf = (row) => all(".pictures img, .pictures .none", row).map((p) => p.cloneNode(true));

  // ---- the words of a dot ----
  const tip = one("#tip");
  let at = null;
  const hide = () => {
    if (at) at.classList.remove("at");
    at = null;
    tip.hidden = true;
  };
  const show = (dot) => {
    if (dot === at) return;
    hide();
    at = dot;
    dot.classList.add("at");
    tip.replaceChildren(document.createTextNode(dot.words + "\n"));
    const row = rowOf.get(dot.dataset.row);
    if (row) tip.append(...picturesOf(row));
    tip.hidden = false;
    const box = dot.getBoundingClientRect(), size = tip.getBoundingClientRect();
    const right = box.right + 12 + size.width < innerWidth;
    tip.style.left = Math.max(4, right ? box.right + 12 : box.left - 12 - size.width) + "px";
    tip.style.top = Math.max(4, Math.min(box.top, innerHeight - size.height - 4)) + "px";
  };
  addEventListener("scroll", hide, {passive: true});
  addEventListener("keydown", (e) => { if (e.key === "Escape") hide(); });

  // ---- charts ----
  const seen = (dot) => !dot.classList.contains("off");
  const middle = (dot) => dot.transform.baseVal.consolidate().matrix;

  // The nearest one: a small dot need not be hit.
  const nearest = (svg, event) => {
    const from = svg.getScreenCTM().inverse();
    const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(from);
    let best = null, least = 20;
    for (const dot of all(".dot", svg).filter(seen)) {
      const m = middle(dot), far = Math.hypot(m.e - p.x, m.f - p.y);
      if (far < least) least = far, best = dot;
    }
    return best;
  };

  // Left and right by cost, up and down by error.
  const neighbour = (dots, dot, key) => {
    const axis = key === "ArrowLeft" || key === "ArrowRight" ? "e" : "f", other = axis === "e" ? "f" : "e";
    const order = dots.slice().sort((a, b) => middle(a)[axis] - middle(b)[axis] || middle(a)[other] - middle(b)[other]);
    const step = key === "ArrowRight" || key === "ArrowDown" ? 1 : -1;
    return order[Math.max(0, Math.min(order.length - 1, order.indexOf(dot) + step))];
  };

  const redrawLines = (svg) => {
    for (const line of all(".line", svg)) {
      const own = all(".dot", svg).filter((d) => d.dataset.family === line.dataset.family);
      line.setAttribute("points", own.map((d) => `${middle(d).e},${middle(d).f}`).join(" "));
      line.classList.toggle("off", !own.some(seen));
    }
    const front = svg.querySelector("polyline.front");
    if (!front) return;
    const on = all(".dot.on-front", svg).map(middle).sort((a, b) => a.e - b.e), corners = [];
    for (const m of on) {
      if (corners.length) corners.push([m.e, corners[corners.length - 1][1]]);
      corners.push([m.e, m.f]);
    }
    const frame = svg.querySelector(".frame");
    const end = frame.x.baseVal.value + frame.width.baseVal.value;
    if (corners.length) corners.push([end, corners[corners.length - 1][1]]);
    front.setAttribute("points", corners.join(" "));
  };

  const place = (figure) => {
    const svg = figure.querySelector(".drawing > svg"), way = {x: 0, y: 0};
    for (const box of all("input[data-log]", figure)) way[box.dataset.log] = box.checked === (box.dataset.first === "1") ? 0 : 1;
    for (const g of all(".ticks", svg)) g.setAttribute("display", Number(g.dataset.way) === way[g.dataset.axis] ? "inline" : "none");
    for (const dot of all(".dot", svg)) {
      const x = dot.dataset.x.split(" ")[way.x], y = dot.dataset.y.split(" ")[way.y];
      dot.setAttribute("transform", `translate(${x} ${y})`);
    }
    for (const label of all(".label", svg)) label.style.display = way.x || way.y ? "none" : "";  // their places are the first ones
    redrawLines(svg);
  };

  for (const figure of all("figure")) {
    const svg = figure.querySelector(".drawing > svg");
    svg.addEventListener("pointermove", (e) => {
      const dot = nearest(svg, e);
      if (dot) show(dot);
      else hide();
    });
    svg.addEventListener("pointerleave", hide);
    svg.addEventListener("click", (e) => {
      const dot = nearest(svg, e);
      if (dot) pick(dot.dataset.row);
    });
    svg.addEventListener("keydown", (e) => {
      const shown = all(".dot", svg).filter(seen);
      if (e.key === "Enter" && at) return pick(at.dataset.row);
      if (!e.key.startsWith("Arrow") || !shown.length) return;
      e.preventDefault();
      const dot = shown.includes(document.activeElement) ? neighbour(shown, document.activeElement, e.key) : shown[0];
      dot.focus({preventScroll: true});
      show(dot);
    });
    svg.addEventListener("focusout", hide);
    const front = figure.querySelector("input[data-front]");
    if (front) front.addEventListener("change", () => { svg.querySelector("polyline.front").style.display = front.checked ? "" : "none"; });
    for (const box of all("input[data-log]", figure)) box.addEventListener("change", () => place(figure));
    for (const box of all("input[data-family]", figure)) box.addEventListener("change", filter);
  }

  // ---- the table ----
  const rank = (cell) => cell.dataset.n === undefined ? cell.textContent.trim() : Number(cell.dataset.n);
  const compare = (a, b) => {
    const numbers = typeof a === "number" && typeof b === "number";
    if (numbers) return a - b;
    return typeof a === typeof b ? a.localeCompare(b) : typeof a === "number" ? -1 : 1;
  };
  for (const th of all("#rows thead th")) {
    const button = document.createElement("button");
    button.type = "button";
    button.append(...th.childNodes);
    th.append(button);
    button.addEventListener("click", () => {
      const ascending = th.getAttribute("aria-sort") !== "ascending";
      for (const other of all("#rows thead th")) other.removeAttribute("aria-sort");
      th.setAttribute("aria-sort", ascending ? "ascending" : "descending");
      const column = th.cellIndex, body = one("#rows tbody");
      const value = (row) => row.cells[column] ? rank(row.cells[column]) : "";
      body.append(...rows.slice().sort((a, b) => (ascending ? 1 : -1) * compare(value(a), value(b))));
    });
  }

  function filter() {
    const box = one("#filter");
    const words = box ? box.value.toLowerCase().split(/\s+/).filter(Boolean) : [];
    for (const dot of dots) {
      const key = `input[data-family="${dot.dataset.family}"][data-sound="${dot.classList.contains("unsound") ? 0 : 1}"]`;
      const input = dot.closest("figure").querySelector(key);
      dot.classList.toggle("off", Boolean(input) && !input.checked);
    }
    let count = 0;
    for (const row of rows) {
      const own = dotsOf.get(row.dataset.row) || [];
      const text = all("th, td:not(.command):not(.pictures)", row).map((c) => c.textContent).join(" ").toLowerCase();
      const fits = words.every((w) => text.includes(w)), on = !own.length || own.some(seen);
      row.hidden = !fits || !on;
      if (!row.hidden) ++count;
      if (!fits) for (const dot of own) dot.classList.add("off");
    }
    for (const svg of all("figure .drawing > svg")) redrawLines(svg);
    if (one("#count")) one("#count").textContent = `${count} of ${rows.length} rows`;
    hide();
  }
  if (one("#filter")) one("#filter").addEventListener("input", filter);

  for (const button of all("[data-copy]"))
    button.addEventListener("click", async () => {
      const code = button.parentElement.querySelector("code");
      try {
        await navigator.clipboard.writeText(code.textContent);
        button.textContent = "copied";
      } catch {  // the browser does not let it: the text is chosen, Ctrl+C copies it
        button.parentElement.querySelector("details").open = true;
        getSelection().selectAllChildren(code);
        button.textContent = "now Ctrl+C";
      }
      setTimeout(() => { button.textContent = "copy"; }, 2000);
    });

  // ---- side by side ----
  const picked = [];
  function pick(row) {
    if (row === undefined || !rowOf.has(row)) return;
    const i = picked.indexOf(row);
    if (i < 0) picked.push(row);
    else picked.splice(i, 1);
    one(`[data-pick="${row}"]`).checked = i < 0;
    rowOf.get(row).classList.toggle("picked", i < 0);
    for (const dot of dotsOf.get(row) || []) dot.classList.toggle("picked", i < 0);
    drawCompared();
  }
  for (const box of all("[data-pick]")) box.addEventListener("change", () => pick(box.dataset.pick));

  const element = (name, text) => {
    const e = document.createElement(name);
    e.textContent = text;
    return e;
  };
  function drawCompared() {
    const section = one("#compared");
    section.hidden = picked.length < 2;
    const table = document.createElement("table"), head = table.createTHead().insertRow();
    head.append(element("th", ""), ...picked.map((r) => element("th", wordsOf(rowOf.get(r)))));
    const body = table.createTBody();
    if (one("#rows .pictures")) {
      const row = body.insertRow();
      row.append(element("th", "picture, error map"));
      for (const r of picked) row.insertCell().append(...picturesOf(rowOf.get(r)));
    }
    details.names.forEach((name, i) => {
      const values = picked.map((r) => details.rows[Number(r)][i] || "");
      if (values.every((v) => v === "")) return;
      const row = body.insertRow();
      row.classList.toggle("differs", values.some((v) => v !== values[0]));
      row.append(element("th", name), ...values.map((v) => element("td", v)));
    });
    section.querySelector(".wide").replaceChildren(table);
  }
  filter();
})();
