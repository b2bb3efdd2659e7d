/* timelines_together.js - the timelines of several traces, one below the other: all show the same interval. */

function showTogether(timelines) {
    if (timelines.length < 2)
        return;
    const traces = timelines.map(t => t.trace), first = d3.least(traces, t => t.start),
          last = d3.greatest(traces, t => t.stop);
    const bounds = {start: first.start, from: first.from, stop: last.stop, to: last.to};
    let together = true, leads = null;
    const follow = leader => {
        if (!together || leads)
            return;
        leads = leader;
        for (const other of timelines)
            if (other !== leader)
                other.setRange(leader.view.from, leader.view.to);
        leads = null;
    };
    const boxes = timelines.map(timeline => {
        const box = checkbox('all runs show this interval', true, on => {
            together = on;
            boxes.forEach(b => { b.querySelector('input').checked = on; });
            follow(timeline);
        });
        timeline.bounds = bounds;
        timeline.onrange.push(() => follow(timeline));
        timeline.controls.append(box);
        return box;
    });
    placeTogether(timelines.map(t => t.section));
    timelines[0].setRange(bounds.start, bounds.stop);
}

/* The sections one behind the other, in the page and in its list. */
function placeTogether(sections) {
    const entry = section => document.querySelector(`nav a[href="#${section.id}"]`).parentElement;
    for (let i = 1; i < sections.length; i++) {
        sections[i - 1].after(sections[i]);
        entry(sections[i - 1]).after(entry(sections[i]));
    }
}
