// Controllers that a person has allowed a page, for hid_port_web.cpp. All of it happens on the page's own thread;
// only there a browser has WebHID.
addToLibrary({
  $webHid__deps: ['web_hid_changed', 'web_hid_came', 'web_hid_opened', 'malloc', 'free'],
  $webHid: {
    known: [],  // path and device; none once it is unplugged, so that its path waits for it
    open: {},  // by number: device, what is under way, and what puts it to rest
    isWatched: false,

    // Two of a kind are told apart by the order in which they came.
    take: (device) => {
      if (webHid.known.some((one) => one.device === device)) return;
      const kind = device.vendorId + ':' + device.productId;
      const alike = webHid.known.filter((one) => one.kind === kind);
      const gone = alike.find((one) => !one.device);
      if (gone) gone.device = device;
      else webHid.known.push({path: 'browser/' + kind + '/' + (alike.length + 1), kind, device});
    },

    at: (path) => webHid.known.find((one) => one.path === path)?.device,

    // A page is not told what a controller is connected by: its reports differ. Sony's have one report for the air;
    // a Switch Pro Controller has one for the cable, and a grip has nothing but a cable.
    isBluetooth: (device) => {
      const has = (id) => device.collections.some((one) => one.outputReports.some((report) => report.reportId === id));
      if (device.vendorId === 0x057e) return !has(0x80) && device.productId !== 0x200e;
      return has(0x11) || has(0x31);
    },

    give: (bytes, use) => {
      const at = _malloc(Math.max(1, bytes.length));
      HEAPU8.set(bytes, at);
      use(at, bytes.length);
      _free(at);
    },

    bytesOf: (view) => new Uint8Array(view.buffer, view.byteOffset, view.byteLength),

    send: (one, bytes) => {
      ++one.waiting;
      one.device.sendReport(bytes[0], bytes.subarray(1)).then(
        () => { --one.waiting; },
        () => { --one.waiting; one.hasFailed = true; });
    },
  },

  web_hid_is_there__proxy: 'sync',
  web_hid_is_there: () => typeof navigator !== 'undefined' && navigator.hid ? 1 : 0,

  web_hid_watch__proxy: 'sync',
  web_hid_watch__deps: ['$webHid'],
  web_hid_watch: () => {
    if (webHid.isWatched) return;
    webHid.isWatched = true;
    navigator.hid.addEventListener('connect', (event) => {
      webHid.take(event.device);
      _web_hid_changed();
    });
    navigator.hid.addEventListener('disconnect', (event) => {
      for (const one of webHid.known) if (one.device === event.device) one.device = null;
      _web_hid_changed();
    });
    navigator.hid.getDevices().then((devices) => {
      devices.forEach(webHid.take);
      _web_hid_changed();
    });
  },

  web_hid_list__proxy: 'sync',
  web_hid_list__deps: ['$webHid', '$stringToNewUTF8'],
  web_hid_list: () => stringToNewUTF8(webHid.known.filter((one) => one.device).map((one) =>
      [one.path, one.device.vendorId, one.device.productId, webHid.isBluetooth(one.device) ? 1 : 0].join(' ')).join('\n')),

  web_hid_has__proxy: 'sync',
  web_hid_has__deps: ['$webHid'],
  web_hid_has: (path) => webHid.at(UTF8ToString(path)) ? 1 : 0,

  // A browser asks in a dialog of its own, and only soon after a press.
  web_hid_ask__proxy: 'sync',
  web_hid_ask__deps: ['$webHid'],
  web_hid_ask: (kinds, count) => {
    const filters = [];
    for (let k = 0; k < count; ++k) {
      filters.push({vendorId: HEAPU16[(kinds >> 1) + 2 * k], productId: HEAPU16[(kinds >> 1) + 2 * k + 1]});
    }
    navigator.hid.requestDevice({filters}).then((devices) => {
      devices.forEach(webHid.take);
      _web_hid_changed();
    }).catch(() => {});
  },

  web_hid_open__proxy: 'sync',
  web_hid_open__deps: ['$webHid'],
  web_hid_open: (number, path) => {
    const device = webHid.at(UTF8ToString(path));
    if (!device) return _web_hid_opened(number, 0);
    const one = webHid.open[number] = {device, waiting: 0, hasFailed: false, rest: null};
    one.hear = (event) => {
      const bytes = new Uint8Array(1 + event.data.byteLength);
      bytes[0] = event.reportId;
      bytes.set(webHid.bytesOf(event.data), 1);
      webHid.give(bytes, (at, size) => _web_hid_came(number, at, size));
    };
    (device.opened ? Promise.resolve() : device.open()).then(() => {
      device.addEventListener('inputreport', one.hear);
      _web_hid_opened(number, 1);
    }).catch(() => _web_hid_opened(number, 0));
  },

  web_hid_close__proxy: 'sync',
  web_hid_close__deps: ['$webHid'],
  web_hid_close: (number) => {
    const one = webHid.open[number];
    if (!one) return;
    delete webHid.open[number];
    one.device.removeEventListener('inputreport', one.hear);
    one.device.close().catch(() => {});
  },

  // Reports that a browser does not get rid of are not added to.
  web_hid_write__proxy: 'sync',
  web_hid_write__deps: ['$webHid'],
  web_hid_write: (number, report, size) => {
    const most = 16;
    const one = webHid.open[number];
    if (!one || one.waiting >= most) return 0;
    const hadFailed = one.hasFailed;
    one.hasFailed = false;
    webHid.send(one, HEAPU8.slice(report, report + size));
    return hadFailed ? 0 : 1;
  },

  web_hid_feature__proxy: 'sync',
  web_hid_feature__deps: ['$webHid', 'web_hid_feature_came'],
  web_hid_feature: (number, report) => {
    const answer = (bytes) => webHid.give(bytes, (at, size) => _web_hid_feature_came(number, at, size));
    const device = webHid.open[number]?.device;
    if (!device) return answer([]);
    device.receiveFeatureReport(report).then((view) => answer(webHid.bytesOf(view))).catch(() => answer([]));
  },

  web_hid_rest_with__proxy: 'sync',
  web_hid_rest_with__deps: ['$webHid'],
  web_hid_rest_with: (number, report, size) => {
    if (webHid.open[number]) webHid.open[number].rest = HEAPU8.slice(report, report + size);
  },

  // Twice: one may be lost on the air.
  web_hid_rest__proxy: 'sync',
  web_hid_rest__deps: ['$webHid'],
  web_hid_rest: () => {
    for (const one of Object.values(webHid.open)) {
      for (let k = 0; k < 2 && one.rest; ++k) webHid.send(one, one.rest);
    }
  },
});
