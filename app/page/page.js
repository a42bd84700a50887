// What the window in a page asks of its browser (page_events.h), as a library of emscripten's.
addToLibrary({
  page_is_there: () => typeof document === 'undefined' ? 0 : 1,

  // Work that pauses until the next frame was drawn (model/system/pauses.h). A hidden page has no frames.
  page_can_pause: () => WebAssembly.promising && WebAssembly.Suspending ? 1 : 0,
  // The page's own stack was left at pausing.page; work has another.
  $pausing: {},
  page_call_with_pauses__deps: ['$pausing', '$getWasmTableEntry', '$stackSave', '$stackRestore'],
  page_call_with_pauses: (run, call, stack) => {
    const page = stackSave();
    Object.assign(pausing, {page, isResumed: false});
    stackRestore(stack);
    WebAssembly.promising(getWasmTableEntry(run))(call).then(() => { if (pausing.isResumed) stackRestore(pausing.page); });
    stackRestore(page);
  },
  page_pause__deps: ['$pausing', '$stackSave', '$stackRestore'],
  page_pause: () => {
    const own = stackSave();
    stackRestore(pausing.page);
    return new Promise((go) => document.hidden ? setTimeout(go) : requestAnimationFrame(() => setTimeout(go))).then(() => {
      Object.assign(pausing, {page: stackSave(), isResumed: true});
      stackRestore(own);
    });
  },
  page_pause__postset: 'if (WebAssembly.Suspending) _page_pause = new WebAssembly.Suspending(_page_pause);',

  page_show_cursor: (name) => {
    document.getElementById('canvas').style.cursor = UTF8ToString(name);
  },

  page_is_for_fingers: () => matchMedia('(pointer: coarse)').matches ? 1 : 0,

  // What a screen reader has of the canvas.
  page_read_out: (words) => {
    document.getElementById('reading').innerText = UTF8ToString(words);
  },

  page_copy: (text) => {
    navigator.clipboard?.writeText(UTF8ToString(text)).catch(() => {});
  },

  $giveText__deps: ['$stringToNewUTF8', 'free'],
  $giveText: (take, text) => {
    const bytes = stringToNewUTF8(text);
    take(bytes);
    _free(bytes);
  },

  // Files of the device, into a folder of the page.
  $giveFiles__deps: ['$FS', '$giveText'],
  $giveFiles: async (files) => {
    const folder = '/dropped';
    if (!FS.analyzePath(folder).exists) FS.mkdir(folder);
    for (const file of files) {
      FS.writeFile(folder + '/' + file.name, new Uint8Array(await file.arrayBuffer()));
    }
    giveText(Module['_page_dropped'], files.map((file) => folder + '/' + file.name).join('\n'));
  },

  page_pick_files__deps: ['$giveFiles'],
  page_pick_files: () => {
    const input = document.createElement('input');
    input.type = 'file';
    input.multiple = true;
    input.onchange = () => giveFiles([...input.files]);
    input.click();
  },

#if PTHREADS
  // A thread starts at once where a worker waits for it, and otherwise only once the page's own thread is idle: so
  // some always wait, the oldest to be taken first.
  $keepSpareWorkers__deps: ['$PThread'],
  $keepSpareWorkers: () => {
    const spare = 3;
    const workers = PThread.unusedWorkers;
    if (workers.length >= spare) return;
    PThread.allocateUnusedWorker();
    PThread.loadWasmModuleToWorker(workers.at(-1));
    workers.unshift(workers.pop());
  },
  page_listen__deps: ['$giveText', '$giveFiles', '$keepSpareWorkers', 'page_hidden'],
#else
  page_listen__deps: ['$giveText', '$giveFiles', 'page_hidden'],
#endif
  page_listen: () => {
#if PTHREADS
    setInterval(keepSpareWorkers, 100);
#endif
    addEventListener('pagehide', () => _page_hidden());
    document.addEventListener('visibilitychange', () => { if (document.hidden) _page_hidden(); });
    addEventListener('paste', (event) => {
      giveText(Module['_page_pasted'], event.clipboardData.getData('text/plain'));
      event.preventDefault();
    });
    addEventListener('contextmenu', (event) => event.preventDefault());
    addEventListener('dragover', (event) => event.preventDefault());
    addEventListener('drop', (event) => {
      event.preventDefault();
      giveFiles([...event.dataTransfer.files]);
    });
  },
});
